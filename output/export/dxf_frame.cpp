// SPDX-License-Identifier: MIT
#include "output/export/dxf_frame.h"

#include "output/export/dxf.h"

namespace camlaw::problems::dxf {
namespace {

using Eigen::Vector2d;

/// Handles of what other parts refer to.
constexpr int kPaper = 0x1B, kRoot = 0xC, kGroups = 0xD;

void header(Tags& tags, const Extent& extent, const LengthUnit& unit, int next_handle) {
  const bool metric = unit.mm == 1;
  tags.text(0, "SECTION");
  tags.text(2, "HEADER");
  tags.text(9, "$ACADVER");
  tags.text(1, "AC1015");
  tags.text(9, "$HANDSEED");
  tags.handle(5, next_handle);
  tags.text(9, "$INSUNITS");
  tags.integer(70, metric ? 4 : 1);  // millimetres, inches
  tags.text(9, "$MEASUREMENT");
  tags.integer(70, metric ? 1 : 0);
  tags.text(9, "$EXTMIN");
  tags.point(10, extent.low);
  tags.text(9, "$EXTMAX");
  tags.point(10, extent.high);
  tags.text(0, "ENDSEC");
}

/// A record of a table, begun: type, handle, owner, subclass, name, flags.
void record(Tags& tags, const char* type, int handle, int table, const char* subclass,
            const std::string& name) {
  tags.text(0, type);
  tags.handle(std::string(type) == "DIMSTYLE" ? 105 : 5, handle);
  tags.handle(330, table);
  tags.text(100, "AcDbSymbolTableRecord");
  tags.text(100, subclass);
  tags.text(2, name);
}

void begin_table(Tags& tags, const char* name, int handle, std::size_t count) {
  tags.text(0, "TABLE");
  tags.text(2, name);
  tags.handle(5, handle);
  tags.integer(330, 0);
  tags.text(100, "AcDbSymbolTable");
  tags.integer(70, static_cast<int>(count));
}

void end_table(Tags& tags) { tags.text(0, "ENDTAB"); }

void line_types(Tags& tags) {
  begin_table(tags, "LTYPE", 0x5, 3);
  int handle = 0x14;
  for (const char* name : {"ByBlock", "ByLayer", "Continuous"}) {
    record(tags, "LTYPE", handle++, 0x5, "AcDbLinetypeTableRecord", name);
    tags.integer(70, 0);
    tags.text(3, "");
    tags.integer(72, 65);
    tags.integer(73, 0);
    tags.real(40, 0);
  }
  end_table(tags);
}

void layers(Tags& tags, const std::vector<std::string>& names) {
  constexpr int kColours[] = {7, 5, 3, 1};  // black or white, blue, green, red
  begin_table(tags, "LAYER", 0x2, names.size() + 1);
  const auto layer = [&](int handle, const std::string& name, int colour) {
    record(tags, "LAYER", handle, 0x2, "AcDbLayerTableRecord", name);
    tags.integer(70, 0);
    tags.integer(62, colour);
    tags.text(6, "Continuous");
  };
  layer(0x10, "0", 7);
  for (std::size_t i = 0; i < names.size(); ++i) {
    layer(0x20 + static_cast<int>(i), names[i], kColours[i % 4]);
  }
  end_table(tags);
}

void text_styles(Tags& tags) {
  begin_table(tags, "STYLE", 0x3, 1);
  record(tags, "STYLE", 0x11, 0x3, "AcDbTextStyleTableRecord", "Standard");
  tags.integer(70, 0);
  for (const auto& [code, value] : {std::pair{40, 0.0}, {41, 1.0}, {50, 0.0}}) {
    tags.real(code, value);
  }
  tags.integer(71, 0);
  tags.real(42, 2.5);
  tags.text(3, "txt");
  tags.text(4, "");
  end_table(tags);
}

/// The tables that a reader of AC1015 asks for, in the order in which it does.
void tables(Tags& tags, const std::vector<std::string>& layer_names) {
  tags.text(0, "SECTION");
  tags.text(2, "TABLES");
  begin_table(tags, "VPORT", 0x8, 0);
  end_table(tags);
  line_types(tags);
  layers(tags, layer_names);
  text_styles(tags);
  for (const auto& [name, handle] : {std::pair{"VIEW", 0x6}, {"UCS", 0x7}}) {
    begin_table(tags, name, handle, 0);
    end_table(tags);
  }
  begin_table(tags, "APPID", 0x9, 1);
  record(tags, "APPID", 0x12, 0x9, "AcDbRegAppTableRecord", "ACAD");
  tags.integer(70, 0);
  end_table(tags);
  begin_table(tags, "DIMSTYLE", 0xA, 1);
  tags.text(100, "AcDbDimStyleTable");
  record(tags, "DIMSTYLE", 0x13, 0xA, "AcDbDimStyleTableRecord", "Standard");
  tags.integer(70, 0);
  end_table(tags);
  begin_table(tags, "BLOCK_RECORD", 0x1, 2);
  record(tags, "BLOCK_RECORD", kModel, 0x1, "AcDbBlockTableRecord", "*Model_Space");
  record(tags, "BLOCK_RECORD", kPaper, 0x1, "AcDbBlockTableRecord", "*Paper_Space");
  end_table(tags);
  tags.text(0, "ENDSEC");
}

void block(Tags& tags, int owner, const std::string& name) {
  const auto begin = [&](const char* type, int handle, const char* subclass) {
    tags.text(0, type);
    tags.handle(5, handle);
    tags.handle(330, owner);
    tags.text(100, "AcDbEntity");
    tags.text(8, "0");
    tags.text(100, subclass);
  };
  begin("BLOCK", owner + 1, "AcDbBlockBegin");
  tags.text(2, name);
  tags.integer(70, 0);
  tags.point(10, Vector2d::Zero());
  tags.text(3, name);
  tags.text(1, "");
  begin("ENDBLK", owner + 2, "AcDbBlockEnd");
}

}  // namespace

void begin(Tags& tags, const Frame& frame) {
  header(tags, frame.extent, frame.unit, frame.next);
  tags.text(0, "SECTION");
  tags.text(2, "CLASSES");
  tags.text(0, "ENDSEC");
  tables(tags, frame.layers);
  tags.text(0, "SECTION");
  tags.text(2, "BLOCKS");
  block(tags, kModel, "*Model_Space");
  block(tags, kPaper, "*Paper_Space");
  tags.text(0, "ENDSEC");
}

void end(Tags& tags) {
  const auto dictionary = [&](int handle, int owner) {
    tags.text(0, "DICTIONARY");
    tags.handle(5, handle);
    tags.handle(330, owner);
    tags.text(100, "AcDbDictionary");
    tags.integer(281, 1);
  };
  tags.text(0, "SECTION");
  tags.text(2, "OBJECTS");
  dictionary(kRoot, 0);
  tags.text(3, "ACAD_GROUP");
  tags.handle(350, kGroups);
  dictionary(kGroups, kRoot);
  tags.text(0, "ENDSEC");
  tags.text(0, "EOF");
}

}  // namespace camlaw::problems::dxf
