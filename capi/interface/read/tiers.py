"""Which tier a header belongs to: one of two sentences in the comment at its head."""
import re

SENTENCES = {
    "stable": "Stable: from version 1.0 on this stays as it is, and is only added to.",
    "provisional": "Provisional: this may change with any minor version, as the changelog then says.",
}


def take_tiers(interface, texts):
    """Sets the tier of each header; `texts`: the headers."""
    for header in interface.headers:
        head = re.sub(r"\s+(\* )?", " ", texts[header].split("*/")[0])
        tiers = [tier for tier, sentence in SENTENCES.items() if sentence in head]
        if len(tiers) == 1:
            interface.tiers[header] = tiers[0]
        else:
            interface.open_headers.append(f"{header}: whether it is stable or provisional")
    for function in interface.functions:
        if interface.tiers.get(function.header) == "stable":
            function.open_questions += [f"a stable function of {base}, which is provisional"
                                        for base in dict.fromkeys(a.base for a in function.arguments)
                                        if interface.tiers.get(interface.home_of(base)) == "provisional"]
