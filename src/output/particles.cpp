#include "output/particles.h"

#include <fmt/format.h>

#include <bit>
#include <numeric>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "output/file.h"

namespace weir {

namespace {

static_assert(std::endian::native == std::endian::little, "the files say that they are little-endian");

template <class T>
constexpr std::string_view type_name() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
}

// The arrays of a file: their descriptions in XML, and their bytes, which are appended behind it. Each has its size in
// front.
class Arrays {
 public:
  template <class T>
  std::string add(std::string_view name, std::size_t components, const std::vector<T>& values) {
    const std::string description = fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
        type_name<T>(), name, components, bytes_.size());
    const std::uint64_t size = values.size() * sizeof(T);
    append(std::span(&size, 1));
    append(std::span(values));
    return description;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  void append(std::span<T> values) {
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  }
  std::string bytes_;
};

template <class T>
std::vector<T> points_of(const std::vector<glm::vec<3, T>>& positions, const glm::dvec3& origin) {
  std::vector<T> points;
  points.reserve(3 * positions.size());
  for (const auto& position : positions) {
    const glm::vec<3, T> point(glm::dvec3(position) + origin);
    points.insert(points.end(), {point.x, point.y, point.z});
  }
  return points;
}

std::string add_points(Arrays& arrays, const Snapshot& snapshot) {
  if (!snapshot.fluid.exact_positions.empty()) {
    return arrays.add("Points", 3, points_of(snapshot.fluid.exact_positions, snapshot.origin));
  }
  return arrays.add("Points", 3, points_of(snapshot.fluid.positions, snapshot.origin));
}

// ParaView draws cells: each particle is one.
std::string add_cells(Arrays& arrays, std::size_t count) {
  std::vector<std::int32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  std::string text = arrays.add("connectivity", 1, numbers);
  std::iota(numbers.begin(), numbers.end(), 1);
  return text + arrays.add("offsets", 1, numbers);
}

template <class T>
std::vector<T> padded(const std::vector<T>& planar) {
  std::vector<T> vectors;
  vectors.reserve(planar.size() / 2 * 3);
  for (std::size_t i = 0; i < planar.size(); i += 2) vectors.insert(vectors.end(), {planar[i], planar[i + 1], T(0)});
  return vectors;
}

std::string add_field(Arrays& arrays, const FieldValues& field) {
  const std::string_view name = name_of(field.quantity);
  return std::visit(
      [&](const auto& values) {
        return field.components == 2 ? arrays.add(name, 3, padded(values)) : arrays.add(name, field.components, values);
      },
      field.values);
}

}  // namespace

std::string particle_file_name(std::int64_t number) { return fmt::format("particles_{:05}.vtp", number); }

std::string particle_file(const Snapshot& snapshot) {
  const std::size_t count = snapshot.fluid.count;
  Arrays arrays;
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n";
  text += fmt::format(
      "<FieldData>\n<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" "
      "format=\"ascii\">{}</DataArray>\n"
      "</FieldData>\n",
      snapshot.time);
  text += fmt::format(
      "<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      count);
  text += "<Points>\n" + add_points(arrays, snapshot) + "</Points>\n";
  text += "<Verts>\n" + add_cells(arrays, count) + "</Verts>\n";
  text += "<PointData>\n";
  for (const FieldValues& field : snapshot.fluid.fields) text += add_field(arrays, field);
  text += "</PointData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  text += arrays.bytes();
  return text += "\n</AppendedData>\n</VTKFile>\n";
}

ParticleWriter::ParticleWriter(std::filesystem::path folder) : folder_(std::move(folder)) { write_collection(); }

void ParticleWriter::write(const Snapshot& snapshot) {
  const std::string name = particle_file_name(count_);
  write_file(folder_ / name, particle_file(snapshot));
  ++count_;
  entries_ += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", snapshot.time, name);
  write_collection();
}

void ParticleWriter::write_collection() const {
  write_file(folder_ / particle_collection_name,
             fmt::format("<?xml version=\"1.0\"?>\n"
                         "<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
                         "<Collection>\n{}</Collection>\n</VTKFile>\n",
                         entries_));
}

}  // namespace weir
