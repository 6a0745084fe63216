# The steps of capi/guide/migration.md from 0.2 to 0.3, as far as programs of 0.2.0 need them.
# Totals before arrays.
s/\(hsp_workspace_areas(.*, 1\.4\), NULL, &totals)/\1, \&totals, NULL)/
s/\(hsp_areas(.*, &bytes\), NULL, totals)/\1, totals, NULL)/
# box before options.
s/\(hsp_workspace_periodic(.*\), &options, box->vector, NULL)/\1, box->vector, \&options, NULL)/
s/\(hsp_workspace_periodic(.*\), NULL, box, NULL)/\1, box, NULL, NULL)/
# Reserved bytes at the end.
s/\(hsp_energy [a-z]* = {0\)[.0, ]*};/\1};/
s/\(hsp_totals [a-z]* = {0\), 0};/\1};/
# An executor's run returns a status, and proceed is behind it.
s/^static void run(void \*context/static int32_t run(void *context/
s/\(hsp_executor executor = {.*, run\)}/\1, NULL}/
/^  for (int k = 0; k < (int)tasks; ++k) task(data, (uint32_t)k);/a\  return 0;
/^  while (started > 0) thrd_join/a\  return 0;
# One owner of the widest probe.
s/hsp_widest_probe /hsp_pore_passage /
s/hsp_workspace_gate(\(&*work\), .*, NULL)/hsp_workspace_pores(\1, NULL)/
s/hsp_gate_get_widest(work->gate, widest)/hsp_pores_widest(work->pores, from, NULL, widest)/
s/^ *check(hsp_gate_get_widest(work\.gate, &widest_probe));/hsp_pore_gate gate;\
check(hsp_pores_widest(work.pores, shells[wall].point, NULL, \&widest_probe));\
check(hsp_pores_get_gates(work.pores, widest_probe.gate, 1, \&gate));/
s/i < 3 && widest_probe\.gate\[i\] != HSP_NONE/i < 3/
s/widest_probe\.gate\[i\]/gate.ball[i]/
