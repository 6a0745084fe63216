/* A plugin for QEMU: appends to the file given as counts=FILE the number of instructions between each call of
 * stage_begins and the next call of stage_ends. Instructions of functions named mem... are not counted: they belong to
 * the C library. Debian's QEMU has no header for plugins, so the parts of their interface, version 1, that are used are
 * declared here. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct qemu_plugin_tb;
struct qemu_plugin_insn;
struct qemu_info_t;
enum { NO_REGISTERS = 0 };
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t k);
const char *qemu_plugin_insn_symbol(const struct qemu_plugin_insn *instruction);
void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id, void (*run)(uint64_t id, struct qemu_plugin_tb *block));
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *block, void (*run)(unsigned processor, void *data),
                                          int registers, void *data);

#define EXPORTED __attribute__((visibility("default")))
EXPORTED extern int qemu_plugin_version;
int qemu_plugin_version = 1;
EXPORTED int qemu_plugin_install(uint64_t id, const struct qemu_info_t *info, int argc, char **argv);

static uint64_t count, begun;
static FILE *counts;

static void executed(unsigned processor, void *instructions) {
  (void)processor;
  count += (uintptr_t)instructions;
}
static void begins(unsigned processor, void *data) {
  (void)processor, (void)data;
  begun = count;
}
static void ends(unsigned processor, void *data) {
  (void)processor, (void)data;
  fprintf(counts, "%" PRIu64 "\n", count - begun);
  fflush(counts);
}

static void translated(uint64_t id, struct qemu_plugin_tb *block) {
  const char *symbol = qemu_plugin_insn_symbol(qemu_plugin_tb_get_insn(block, 0));
  (void)id;
  if (symbol == NULL) symbol = "";
  if (strcmp(symbol, "stage_begins") == 0) qemu_plugin_register_vcpu_tb_exec_cb(block, begins, NO_REGISTERS, NULL);
  if (strcmp(symbol, "stage_ends") == 0) qemu_plugin_register_vcpu_tb_exec_cb(block, ends, NO_REGISTERS, NULL);
  if (strncmp(symbol + strspn(symbol, "_"), "mem", 3) == 0) return;
  qemu_plugin_register_vcpu_tb_exec_cb(block, executed, NO_REGISTERS, (void *)(uintptr_t)qemu_plugin_tb_n_insns(block));
}

int qemu_plugin_install(uint64_t id, const struct qemu_info_t *info, int argc, char **argv) {
  const char *const file = argc == 1 ? strchr(argv[0], '=') : NULL;
  (void)info;
  if (file == NULL || (counts = fopen(file + 1, "a")) == NULL) return 1;
  qemu_plugin_register_vcpu_tb_trans_cb(id, translated);
  return 0;
}
