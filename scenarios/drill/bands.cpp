#include "scenarios/drill/bands.hpp"

#include <algorithm>

#include "scenarios/drill/names.hpp"
#include "scenarios/drill/schema.hpp"

namespace scenarios::drill {

Band read_band(const JsonText& document, const json& entry, const std::string& pointer) {
    if (entry.is_object()) return {0, entry["max"]};
    const Band read{entry[0], entry[1]};
    if (read.low > read.high)
        document.fail(pointer, "expected [low, high], found " + shown(read.low) + " above " + shown(read.high));
    return read;
}

static std::vector<std::optional<Band>> per_instrument(const JsonText& document, const json& entries,
                                                       const std::string& pointer, const world::WorldDef& world) {
    std::vector<std::optional<Band>> read(world.instruments.size());
    for (const auto& [name, entry] : entries.items()) {
        const auto found = std::find_if(world.instruments.begin(), world.instruments.end(),
                                        [&, &named = name](const auto& tool) { return tool.name == named; });
        const std::string place = pointer + "/" + pointer_part(name);
        if (found == world.instruments.end())
            document.fail(place, "no instrument has this name, expected " + names_of(world.instruments), true);
        read[static_cast<std::size_t>(found - world.instruments.begin())] = read_band(document, entry, place);
    }
    return read;
}

// What cannot be measured would pass unseen, or never pass.
static void check_sewing(const JsonText& document, const json& entries, const world::WorldDef& world) {
    const auto refuse = [&](std::initializer_list<const char*> keys, const std::string& what) {
        for (const char* key : keys)
            if (entries.contains(key)) document.fail(std::string("/bands/") + key, what);
    };
    const bool has_needle = !world.needle_code.empty();
    if (!has_needle)
        refuse({"needle_deg", "bites", "bite_mm", "bite_deg"},
               "the thread has no needle: give it one (\"needle\"), or leave this out");
    if (world.vessels.empty())
        refuse({"bites", "bite_mm", "bite_deg"}, "there is no vessel to bite: add one, or leave this out");
    if (std::ranges::none_of(world.vessels, [](const auto& vessel) { return vessel.is_soft; }))
        refuse({"walls_crossed"},
               "no wall gives way, and tools stop at rigid ones: expected \"tissue\": \"elastic\", or leave this out");
    if (!entries.contains("bites"))
        refuse({"bite_mm", "bite_deg"}, "expected \"bites\" as well, how many there must be");
    if (!has_needle || world.vessels.size() != 2)
        refuse({"gap_mm", "lumen", "leak_mL_min", "lapses"},
               "a join is of two vessels sewn by a needle, expected both");
}

Bands read_bands(const JsonText& document, const json& entries, const world::WorldDef& world) {
    Bands bands;
    using Single = std::pair<const char*, std::optional<Band> Bands::*>;
    for (const auto& [key, member] : {Single{"time_s", &Bands::time_s},
                                      {"tension_N", &Bands::tension_N},
                                      {"pass_throughs", &Bands::pass_throughs},
                                      {"walls_crossed", &Bands::walls_crossed},
                                      {"needle_deg", &Bands::needle_deg},
                                      {"bites", &Bands::bites},
                                      {"bite_mm", &Bands::bite_mm},
                                      {"bite_deg", &Bands::bite_deg},
                                      {"gap_mm", &Bands::gap_mm},
                                      {"lumen", &Bands::lumen},
                                      {"leak_mL_min", &Bands::leak_mL_min},
                                      {"lapses", &Bands::lapses}})
        if (entries.contains(key)) bands.*member = read_band(document, entries[key], std::string("/bands/") + key);
    check_sewing(document, entries, world);
    bands.path_mm = per_instrument(document, entries["path_mm"], "/bands/path_mm", world);
    bands.grasps = per_instrument(document, entries["grasps"], "/bands/grasps", world);
    bands.lag_mm = per_instrument(document, entries["lag_mm"], "/bands/lag_mm", world);
    return bands;
}

}  // namespace scenarios::drill
