#include "sim/ballistics/shipped.h"
#include "sim/core/text.h"

#include <npsee/projectile.h>

namespace npsee {

using namespace ballistics;

std::vector<std::string_view> shippedProjectiles() {
  return namesOf(shippedProjectileFiles(), &ShippedFile::name);
}

Expected<Projectile> findProjectile(std::string_view choice) {
  if (choice.find_first_of("./\\") != std::string_view::npos) return loadProjectile(std::filesystem::path(choice));
  for (const ShippedFile& file : shippedProjectileFiles())
    if (file.name == choice) return parseProjectile(file.text, "assets/projectiles/" + std::string(file.name) + ".json");
  const auto names = shippedProjectiles();
  const auto near = nearest(choice, names);
  return fail(ErrorKind::usage, "there is no projectile \"" + std::string(choice) + "\".",
              (near ? "Did you mean " + std::string(*near) + "? " : std::string()) + "There are " + listed(names) + "; a file is known by its dot or slash.");
}

}  // namespace npsee
