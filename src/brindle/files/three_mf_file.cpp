#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/base/checksum.h"
#include "brindle/error.h"
#include "brindle/files/binary_numbers.h"
#include "brindle/files/mesh_formats.h"

namespace brindle {
namespace {

/// A ZIP archive of uncompressed files.
class ZipOutput {
 public:
  explicit ZipOutput(OutputStream& out) : binary_(out) {}

  void add(std::string_view name, std::string_view content) {
    if (content.size() > std::numeric_limits<std::uint32_t>::max() - written_ - 1000) {
      throw Error("the mesh is too large for .3mf, which ends at 4 GB; write .stl or .ply");
    }
    entries_.push_back({std::string(name), crc32_of(content),
                        static_cast<std::uint32_t>(content.size()), written_});
    put(std::uint32_t{0x04034b50});
    put_entry(entries_.back());
    put_bytes(name);
    put_bytes(content);
  }

  void finish() {
    const std::uint32_t begin = written_;
    for (const Entry& entry : entries_) {
      put(std::uint32_t{0x02014b50});
      put(kVersion);
      put_entry(entry);
      put(std::array<std::uint16_t, 5>{});  // no comment, disk or attributes
      put(entry.at);
      put_bytes(entry.name);
    }
    const std::uint32_t size = written_ - begin;
    const auto count = static_cast<std::uint16_t>(entries_.size());
    put(std::uint32_t{0x06054b50});
    put(std::uint32_t{0});
    put(count);
    put(count);
    put(size);
    put(begin);
    put(std::uint16_t{0});
  }

 private:
  struct Entry {
    std::string name;
    std::uint32_t sum, size, at;
  };
  static constexpr std::uint16_t kVersion = 20;

  template <class Value>
  void put(const Value& value) {
    binary_.put(value);
    written_ += sizeof(Value);
  }
  void put_bytes(std::string_view bytes) {
    binary_.put(bytes.data(), bytes.size());
    written_ += static_cast<std::uint32_t>(bytes.size());
  }
  void put_entry(const Entry& entry) {
    put(kVersion);
    put(std::uint32_t{0});           // no flags, uncompressed
    put(std::uint32_t{0x00210000});  // 1 January 1980: the same bytes every time
    put(entry.sum);
    put(entry.size);
    put(entry.size);
    put(static_cast<std::uint16_t>(entry.name.size()));
    put(std::uint16_t{0});
  }

  BinaryOutput binary_;
  std::vector<Entry> entries_;
  std::uint32_t written_ = 0;
};

constexpr std::string_view kTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
)";

constexpr std::string_view kRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
)";

template <class Point>
void put_vertex(const Point& p, TextOutput& text) {
  text << "<vertex x=\"" << p.x() << "\" y=\"" << p.y() << "\" z=\"" << p.z() << "\"/>\n";
}

std::string model_of(const Mesh& mesh) {
  std::string model;
  {
    OutputStream out(model);
    TextOutput text(out);
    text << R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>
)";
    for (const Vec3& p : mesh.positions) {
      if (mesh.origin.isZero(0)) {
        put_vertex(p, text);
      } else {
        put_vertex(Eigen::Vector3d(p.cast<double>() + mesh.origin), text);
      }
    }
    text << "</vertices><triangles>\n";
    for (const Triangle& t : mesh.triangles) {
      text << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2] << "\"/>\n";
    }
    text << "</triangles></mesh></object></resources><build><item "
            "objectid=\"1\"/></build></model>\n";
  }
  return model;
}

}  // namespace

void write_3mf(OutputStream& out, const Mesh& mesh) {
  ZipOutput zip(out);
  zip.add("[Content_Types].xml", kTypes);
  zip.add("_rels/.rels", kRelations);
  zip.add("3D/3dmodel.model", model_of(mesh));
  zip.finish();
}

}  // namespace brindle
