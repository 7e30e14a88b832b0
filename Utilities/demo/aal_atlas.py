# SPDX-License-Identifier: GPL-3.0-or-later
"""Names and colours of the regions of the AAL atlas (Tzourio-Mazoyer et al. 2002)."""

UNLABELLED = 0
UNLABELLED_COLOUR = "#d9d9d9"

# Left and right share a colour. A lobe is a family of hues: frontal blue, parietal green, occipital red,
# temporal orange, limbic purple, cerebellum brown. Regions that touch on the left half of the brain are
# at least 25 units apart in CIELAB, which no formula from label to colour gave.
REGION_COLOURS = {
    "Precentral": "#2e86e9",
    "Frontal_Sup": "#1819e6",
    "Frontal_Sup_Orb": "#17aee9",
    "Frontal_Mid": "#d3c6ed",
    "Frontal_Mid_Orb": "#1b6bec",
    "Frontal_Inf_Oper": "#3231c4",
    "Frontal_Inf_Tri": "#3aa4ba",
    "Frontal_Inf_Orb": "#631ce8",
    "Rolandic_Oper": "#95b6f4",
    "Supp_Motor_Area": "#9a94f1",
    "Olfactory": "#996eea",
    "Frontal_Sup_Medial": "#81daf2",
    "Frontal_Med_Orb": "#723eed",
    "Rectus": "#3c53b7",
    "Insula": "#c57ed9",
    "Cingulum_Ant": "#eca9eb",
    "Cingulum_Mid": "#9b39b8",
    "Cingulum_Post": "#d02ed0",
    "Hippocampus": "#aa4788",
    "ParaHippocampal": "#d867de",
    "Amygdala": "#cb2c9b",
    "Calcarine": "#f4c2d1",
    "Cuneus": "#dd1731",
    "Lingual": "#e9306d",
    "Occipital_Sup": "#f2759e",
    "Occipital_Mid": "#bc3539",
    "Occipital_Inf": "#eb1e18",
    "Fusiform": "#f59bb5",
    "Postcentral": "#7dd430",
    "Parietal_Sup": "#26d592",
    "Parietal_Inf": "#dcf4c1",
    "SupraMarginal": "#3bb7a2",
    "Angular": "#34da2f",
    "Precuneus": "#bef2e7",
    "Paracentral_Lobule": "#48ab6c",
    "Caudate": "#7b6888",
    "Putamen": "#b689b6",
    "Pallidum": "#a89ab1",
    "Thalamus": "#885c97",
    "Heschl": "#f8b757",
    "Temporal_Sup": "#f55309",
    "Temporal_Pole_Sup": "#f8e647",
    "Temporal_Mid": "#fbc59f",
    "Temporal_Pole_Mid": "#d86a25",
    "Temporal_Inf": "#edbe0d",
    "Cerebelum_Crus1": "#9a7159",
    "Cerebelum_Crus2": "#a3a24f",
    "Cerebelum_3": "#96955e",
    "Cerebelum_4_5": "#ba8857",
    "Cerebelum_6": "#c0bf68",
    "Cerebelum_7b": "#e9e7cb",
    "Cerebelum_8": "#b3af4c",
    "Cerebelum_9": "#d6d39b",
    "Cerebelum_10": "#8a7969",
    "Vermis_1_2": "#8c8764",
    "Vermis_3": "#bab9a2",
    "Vermis_4_5": "#cea58b",
    "Vermis_6": "#b7944f",
    "Vermis_7": "#e8d2c7",
    "Vermis_8": "#a56d4d",
    "Vermis_9": "#af7748",
    "Vermis_10": "#a6978e",
}


def read_names(path):
    """Reads mricron's lines `<label> <name> <code>`; returns {label: name}."""
    names = {}
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            fields = line.split()
            if len(fields) == 3:
                names[int(fields[0])] = fields[1]
    return names


def colour_of(name):
    """The colour of a region, as red, green and blue in [0,1]."""
    stem = name[:-2] if name.endswith(("_L", "_R")) else name
    code = REGION_COLOURS.get(stem, UNLABELLED_COLOUR)
    return tuple(int(code[k : k + 2], 16) / 255 for k in (1, 3, 5))
