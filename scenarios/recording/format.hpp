#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "instruments/tool.hpp"

namespace scenarios::recording {

constexpr int format_version = 2;                    ///< Version that is written, as PRAGMA user_version.
constexpr int oldest_version = 1;                    ///< Oldest version that is read.
constexpr std::int32_t application_id = 0x4352454c;  ///< What marks a recording, as PRAGMA application_id: "CREL".
constexpr std::size_t numbers_per_tool = 8;          ///< Numbers of an input: x, y, z [m], qw, qx, qy, qz, jaw.
constexpr std::size_t most_ticks = 65536;  ///< Most ticks in a chunk: more are damage, not a request for memory.
constexpr std::size_t most_tools = 16;     ///< Most tools in a recording: more are damage, not a request for memory.

/// What a recording is made of, the head first, so that a file whose end is lost keeps its drill; docs/recordings.md
/// says what each column means. head, engine: one row. session: one row or none. chunk: inputs of `ticks` ticks from
/// `first_tick`, packed as pack() does. finished: a row once complete. chain, view: nothing is written to them nor read
/// from them yet. state_hash comes last, for it has rows always, so that its damage shows. Version 1 had head,
/// instrument, asset, chunk, state_hash, event, score and finished.
constexpr const char* head_tables = R"(
CREATE TABLE head(drill_text TEXT NOT NULL, drill_name TEXT NOT NULL, program_version TEXT NOT NULL,
                  tick_s REAL NOT NULL);
CREATE TABLE instrument(place INTEGER PRIMARY KEY, name TEXT NOT NULL);
CREATE TABLE asset(name TEXT NOT NULL, sha256 TEXT NOT NULL);
)";
/// The tables behind the head, in the order in which they are made.
constexpr const char* other_tables = R"(
CREATE TABLE chain(first_tick INTEGER PRIMARY KEY, sha256 TEXT NOT NULL);
CREATE TABLE view(tick INTEGER PRIMARY KEY, seen BLOB NOT NULL);
CREATE TABLE engine(source TEXT NOT NULL, compiler TEXT NOT NULL, flags TEXT NOT NULL, libraries TEXT NOT NULL);
CREATE TABLE session(who TEXT NOT NULL, device TEXT NOT NULL, assists TEXT NOT NULL, exam INTEGER NOT NULL,
                     pace REAL NOT NULL, machine TEXT NOT NULL, parent TEXT NOT NULL, parent_tick INTEGER NOT NULL);
CREATE TABLE pace(tick INTEGER NOT NULL, wall_s REAL NOT NULL, rate REAL NOT NULL, dropped_ms REAL NOT NULL,
                  used_p50_ms REAL, used_p99_ms REAL, shown_p50_ms REAL, shown_p99_ms REAL);
CREATE TABLE mark(tick INTEGER NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL);
CREATE TABLE measure(place INTEGER PRIMARY KEY, name TEXT NOT NULL, number REAL NOT NULL, unit TEXT NOT NULL,
                     at_s REAL NOT NULL, at_tick INTEGER NOT NULL);
CREATE TABLE chunk(first_tick INTEGER PRIMARY KEY, ticks INTEGER NOT NULL, inputs BLOB NOT NULL);
CREATE TABLE finished(ticks INTEGER NOT NULL);
CREATE TABLE score(name TEXT NOT NULL, title TEXT NOT NULL, value TEXT NOT NULL, unit TEXT NOT NULL, band TEXT NOT NULL,
                   passed INTEGER NOT NULL, at_s REAL, why TEXT NOT NULL);
CREATE TABLE event(t_s REAL NOT NULL, kind TEXT NOT NULL, what TEXT NOT NULL, value REAL);
CREATE TABLE state_hash(tick INTEGER PRIMARY KEY, hash TEXT NOT NULL);
)";

/// Packs whole ticks of `tools` tools: a zstd frame with checksum, of little-endian doubles ordered by tool, then
/// number, then tick, so that slowly varying columns lie together. Every bit comes back, NaN payloads and -0 included.
std::vector<char> pack(std::span<const instruments::ToolInput> inputs, std::size_t tools);

/// The inputs of `ticks` ticks, or empty when the bytes are damaged or of another length.
std::vector<instruments::ToolInput> unpack(std::span<const char> bytes, std::size_t ticks, std::size_t tools);

}  // namespace scenarios::recording
