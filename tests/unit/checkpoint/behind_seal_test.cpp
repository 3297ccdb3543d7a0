// Files with a valid header around an HDF5 part that another program made: what libhdf5 reads well,
// but rupture never writes, is refused in one sentence, before much memory is taken.
#include <hdf5.h>

#include <array>
#include <functional>

#include "../../../src/checkpoint/hdf5_handle.hpp"
#include "fixtures.hpp"

namespace rupture {
namespace {

using hdf5::check;
using hdf5::Handle;
using testing::expect_contains;

constexpr const char* kPath = "/state/u_x";

// Properties of the dataset that is created at kPath.
struct Replacement {
  hid_t type = H5T_IEEE_F64LE;
  std::vector<hsize_t> shape = {4, 5};
  std::function<void(hid_t)> storage = [](hid_t) {};
};

class BehindSeal : public testing::InFolder {
 protected:
  // The refusal to read the small checkpoint after `change` to its HDF5 part.
  std::string refusal_after(const std::function<void(hid_t)>& change) {
    write_checkpoint(file("x.h5"), testing::small_checkpoint(), IfExists::replace);
    hdf5::prepare();
    {
      const Handle opened(H5Fopen(file("x.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                          "open");
      change(opened);
    }
    std::string bytes = testing::slurp(file("x.h5"));
    const auto body = testing::bytes_of(bytes).subspan(kHeaderSize);
    const std::string header = header_text(FileKind::checkpoint, body);
    bytes.replace(0, kHeaderSize, header);
    return testing::failure_of([&] { read_bytes(testing::bytes_of(bytes), "x.h5"); });
  }

  std::string refusal_of(const Replacement& with) {
    return refusal_after([&](hid_t opened) {
      check(H5Ldelete(opened, kPath, H5P_DEFAULT), "delete");
      const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "prepare");
      with.storage(properties);
      const Handle space(
          H5Screate_simple(static_cast<int>(with.shape.size()), with.shape.data(), nullptr),
          H5Sclose, "create a shape");
      const Handle dataset(
          H5Dcreate2(opened, kPath, with.type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
          H5Dclose, "create");
    });
  }
};

Handle type_of(hid_t id) {
  return {id, H5Tclose, "make a type"};
}

TEST_F(BehindSeal, intact_files_pass) {
  EXPECT_EQ(refusal_after([](hid_t) {}), "(no failure)");
}

TEST_F(BehindSeal, shapes_that_the_file_cannot_hold_are_refused) {
  const hsize_t large = hsize_t{1} << 58U;
  expect_contains(refusal_of({.shape = {large}}),
                  "x.h5: /state/u_x claims [288230376151711744] elements of 8 bytes, more than the "
                  "file can hold");
  const hsize_t factor = hsize_t{1} << 29U;
  expect_contains(refusal_of({.shape = {factor, factor}}),
                  "/state/u_x claims [536870912][536870912]");
}

TEST_F(BehindSeal, a_text_longer_than_the_file_is_refused) {
  const Handle text = type_of(H5Tcopy(H5T_C_S1));
  check(H5Tset_size(text, std::size_t{1} << 31U), "make it long");
  check(H5Tset_strpad(text, H5T_STR_NULLPAD), "pad it");
  check(H5Tset_cset(text, H5T_CSET_UTF8), "encode it");
  const std::string refusal = refusal_after([&](hid_t opened) {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
    const Handle dataset(
        H5Dcreate2(opened, "/long", text, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
        "create");
  });
  expect_contains(refusal, "/long claims [1] elements of 2147483648 bytes");
}

TEST_F(BehindSeal, other_shapes_are_refused) {
  expect_contains(refusal_of({.shape = {4, 5, 1}}),
                  "/state/u_x holds 0 bytes, but its shape [4][5][1] needs 160");
  const std::string refusal = refusal_after([](hid_t opened) {
    const Handle space(H5Screate(H5S_NULL), H5Sclose, "create no shape");
    const Handle dataset(
        H5Dcreate2(opened, "/none", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose, "create");
  });
  expect_contains(refusal, "/none is empty, without even a shape");
}

TEST_F(BehindSeal, types_that_are_never_written_are_refused) {
  for (const hid_t type : {H5T_IEEE_F32BE, H5T_IEEE_F64BE, H5T_STD_I32LE, H5T_STD_U64LE,
                           H5T_STD_I64BE, H5T_STD_REF_OBJ, H5T_STD_REF_DSETREG, H5T_STD_B64LE}) {
    expect_contains(refusal_of({.type = type}),
                    "x.h5: /state/u_x has an element type that rupture never writes");
  }
  const auto refusal_of_type = [&](const Handle& type) { return refusal_of({.type = type}); };
  const std::string never = "/state/u_x has an element type that rupture never writes";
  const Handle compound = type_of(H5Tcreate(H5T_COMPOUND, 8));
  check(H5Tinsert(compound, "member", 0, H5T_IEEE_F64LE), "add a member");
  expect_contains(refusal_of_type(compound), never);
  expect_contains(refusal_of_type(type_of(H5Tcreate(H5T_OPAQUE, 8))), never);
  expect_contains(refusal_of_type(type_of(H5Tvlen_create(H5T_IEEE_F64LE))), never);
  const Handle words = type_of(H5Tenum_create(H5T_STD_I64LE));
  const std::int64_t zero = 0;
  check(H5Tenum_insert(words, "zero", &zero), "name a value");
  expect_contains(refusal_of_type(words), never);
  const hsize_t two = 2;
  expect_contains(refusal_of_type(type_of(H5Tarray_create2(H5T_IEEE_F64LE, 1, &two))), never);
  const Handle text = type_of(H5Tcopy(H5T_C_S1));
  check(H5Tset_size(text, H5T_VARIABLE), "make its length variable");
  expect_contains(refusal_of_type(text), never);
}

TEST_F(BehindSeal, storage_that_is_never_used_is_refused) {
  const std::array<hsize_t, 2> chunk = {2, 5};
  const auto chunked = [&](hid_t p) { check(H5Pset_chunk(p, 2, chunk.data()), "cut into chunks"); };
  const auto compressed = [&](hid_t p) {
    chunked(p);
    check(H5Pset_deflate(p, 9), "compress");
  };
  const auto external = [](hid_t p) {
    check(H5Pset_external(p, "/dev/zero", 0, 160), "put elsewhere");
  };
  const auto virtually = [](hid_t p) {
    const std::array<hsize_t, 2> lengths = {4, 5};
    const Handle space(H5Screate_simple(2, lengths.data(), nullptr), H5Sclose, "create a shape");
    check(H5Pset_virtual(p, space, "other.h5", "/x", space), "put into another file");
  };
  for (const std::function<void(hid_t)>& storage :
       {std::function<void(hid_t)>(chunked), std::function<void(hid_t)>(compressed),
        std::function<void(hid_t)>(external), std::function<void(hid_t)>(virtually)}) {
    expect_contains(refusal_of({.storage = storage}),
                    "x.h5: /state/u_x is not stored as rupture does, in one piece in this file");
  }
  expect_contains(refusal_of({}), "/state/u_x holds 0 bytes, but its shape [4][5] needs 160");
}

TEST_F(BehindSeal, links_that_are_followed_by_name_are_refused) {
  expect_contains(
      refusal_after([](hid_t opened) {
        check(H5Lcreate_soft("/state/u_x", opened, "/state/link", H5P_DEFAULT, H5P_DEFAULT),
              "link");
      }),
      "x.h5: /state/ holds a symbolic link, which rupture never writes");
  expect_contains(
      refusal_after([](hid_t opened) {
        check(H5Lcreate_external("/etc/passwd", "/", opened, "link", H5P_DEFAULT, H5P_DEFAULT),
              "link");
      }),
      "x.h5: / holds a symbolic link");
}

TEST_F(BehindSeal, groups_in_themselves_are_refused) {
  expect_contains(
      refusal_after([](hid_t opened) {
        check(H5Lcreate_hard(opened, "/state", opened, "/state/again", H5P_DEFAULT, H5P_DEFAULT),
              "link");
      }),
      "/again/ is too deep a group");
  expect_contains(
      refusal_after([](hid_t opened) {
        check(H5Lcreate_hard(opened, "/", opened, "/state/again", H5P_DEFAULT, H5P_DEFAULT),
              "link");
      }),
      " is too deep a group");
}

// Seven groups, each of which holds the next one a hundred times: 10^14 ways to the last.
TEST_F(BehindSeal, groups_with_very_many_ways_to_them_are_refused) {
  const std::string refusal = refusal_after([](hid_t opened) {
    for (int depth = 0; depth < 7; ++depth) {
      const std::string name = "/g" + std::to_string(depth);
      const Handle group(H5Gcreate2(opened, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose, "create");
      for (int n = 0; depth > 0 && n < 100; ++n) {
        const std::string below = "/g" + std::to_string(depth - 1);
        check(H5Lcreate_hard(opened, below.c_str(), group, std::to_string(n).c_str(), H5P_DEFAULT,
                             H5P_DEFAULT),
              "link");
      }
    }
  });
  expect_contains(refusal, "and what comes before it need more than the file holds");
}

TEST_F(BehindSeal, objects_of_other_kinds_are_refused) {
  expect_contains(refusal_after([](hid_t opened) {
                    const Handle type = type_of(H5Tcopy(H5T_IEEE_F64LE));
                    check(H5Tcommit2(opened, "/type", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                          "name it");
                  }),
                  "x.h5: /type is neither a group nor a dataset");
}

// Replaces an attribute by one of int32.
void set_number(hid_t opened, const char* object, const char* attribute) {
  const Handle holder(H5Oopen(opened, object, H5P_DEFAULT), H5Oclose, "open");
  check(H5Adelete(holder, attribute), "delete");
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "create a scalar");
  const Handle created(
      H5Acreate2(holder, attribute, H5T_STD_U32LE, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      "create");
  const std::uint32_t value = 1;
  check(H5Awrite(created, H5T_NATIVE_UINT32, &value), "write");
}

TEST_F(BehindSeal, wrong_attributes_are_refused) {
  expect_contains(refusal_after([](hid_t opened) { set_number(opened, kPath, "unit"); }),
                  "x.h5: the attribute unit of /state/u_x holds one uint32; expected text");
  expect_contains(refusal_after([](hid_t opened) { set_number(opened, "/", "format"); }),
                  "x.h5: format holds one uint32; expected text");
  expect_contains(refusal_after([](hid_t opened) { set_number(opened, "/", "schema_version"); }),
                  "x.h5: schema_version holds one uint32; expected one int64");
  expect_contains(refusal_after([](hid_t opened) { check(H5Adelete(opened, "format"), "delete"); }),
                  "x.h5: format is missing; expected text");
  expect_contains(refusal_after([](hid_t opened) {
                    check(H5Adelete_by_name(opened, kPath, "unit", H5P_DEFAULT), "delete");
                  }),
                  "x.h5: could not read the attribute unit of /state/u_x");
}

TEST_F(BehindSeal, numbers_that_are_not_finite_are_refused) {
  for (const auto& [number, text] :
       {std::pair(std::nan(""), "nan"), std::pair(HUGE_VAL, "inf"), std::pair(-HUGE_VAL, "-inf")}) {
    const std::vector<double> values(20, number);
    expect_contains(
        refusal_after([&](hid_t opened) {
          const Handle dataset(H5Dopen2(opened, kPath, H5P_DEFAULT), H5Dclose, "open");
          check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
                "write");
        }),
        std::string("x.h5: /state/u_x holds ") + text + " at index 0 of [4][5]");
  }
}

TEST_F(BehindSeal, changed_or_deleted_datasets_do_not_have_the_checksum_that_is_stored) {
  expect_contains(
      refusal_after([](hid_t opened) { check(H5Ldelete(opened, kPath, H5P_DEFAULT), "delete"); }),
      "x.h5: its content has the checksum ");
}

}  // namespace
}  // namespace rupture
