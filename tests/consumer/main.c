/* What a program in C does with libnpsee, each result on a line of its own, numbers with all their digits:
 *
 *   c_consumer particles PRESET TIME THREADS [SETTING]   the columns of `npsee particles` from age_s to a, then bounces; alive first
 *   c_consumer fly CHARGE ELEVATION_RAD                  range and time of flight of an m107
 *   c_consumer aim CHARGE RANGE_M                        lower elevation
 *   c_consumer mission FILE                              the event log as it comes
 *   c_consumer orders FILE                               what the log says of orders that nobody can obey, up to 5 s
 *   c_consumer record FILE RECORDING                     the mission to its end, saved
 *   c_consumer recording FILE TIME                       duration and hash; the events from a time on; vehicles and shells at it
 *   c_consumer errors RECORDING                          every misuse must be refused; prints "refused N"
 */

#include <npsee/c.h>

#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void need(npsee_status status) {
  if (status == NPSEE_OK) return;
  fprintf(stderr, "%s\n", npsee_last_error());
  exit((int)status);
}

static double* column(size_t count) {
  double* out = malloc((count + 1) * sizeof *out);
  if (out == NULL) exit(6);
  return out;
}

static void particles(const char* file, double t_s, int threads, const char* setting) {
  npsee_preset* preset = NULL;
  npsee_explosion* explosion = NULL;
  npsee_compile_options options = npsee_compile_options_default();
  npsee_frame frame;
  double* columns[12];
  size_t i, count;
  int k;
  options.threads = threads;
  need(npsee_preset_load(file, &preset));
  if (setting != NULL) need(npsee_preset_set(preset, setting));
  need(npsee_explosion_compile(preset, &options, &explosion));
  npsee_preset_free(preset);
  count = npsee_explosion_particles(explosion);
  for (k = 0; k < 12; ++k) columns[k] = column(count);
  memset(&frame, 0, sizeof frame);
  frame.capacity = count;
  frame.age = columns[0];
  frame.x = columns[1];
  frame.y = columns[2];
  frame.z = columns[3];
  frame.vx = columns[4];
  frame.vy = columns[5];
  frame.vz = columns[6];
  frame.size = columns[7];
  frame.r = columns[8];
  frame.g = columns[9];
  frame.b = columns[10];
  frame.a = columns[11];
  frame.alive = malloc(count + 1);
  frame.bounces = malloc(count + 1);
  if (frame.alive == NULL || frame.bounces == NULL) exit(6);
  need(npsee_explosion_at(explosion, t_s, &frame, threads));
  for (i = 0; i < count; ++i) {
    printf("%d", frame.alive[i]);
    for (k = 0; k < 12; ++k) printf(" %.17g", columns[k][i]);
    printf(" %d\n", frame.bounces[i]);
  }
  for (k = 0; k < 12; ++k) free(columns[k]);
  free(frame.alive);
  free(frame.bounces);
  npsee_release_scratch();
  npsee_explosion_free(explosion);
}

static npsee_ballistics* howitzer(npsee_projectile** projectile) {
  npsee_ballistics* ballistics = NULL;
  need(npsee_projectile_find("m107", projectile));
  need(npsee_ballistics_make(*projectile, NULL, &ballistics));
  return ballistics;
}

static void fly(const char* charge, double elevation_rad) {
  npsee_projectile* projectile = NULL;
  npsee_ballistics* ballistics = howitzer(&projectile);
  npsee_shot shot;
  npsee_flight flight;
  npsee_path* path = NULL;
  double place[3], velocity[3], spin;
  need(npsee_projectile_shot(projectile, charge, elevation_rad, &shot));
  need(npsee_ballistics_fly(ballistics, &shot, &flight));
  printf("range_m %.17g\ntime_of_flight_s %.17g\ndrift_m %.17g\n", flight.range_m, flight.time_of_flight_s, flight.drift_m);
  need(npsee_ballistics_path(ballistics, &shot, &path));
  need(npsee_path_at(path, flight.time_of_flight_s, 0, place, velocity, &spin));
  printf("last_x_m %.17g\nlast_y_m %.17g\n", place[0], place[1]);
  npsee_path_free(path);
  npsee_ballistics_free(ballistics);
  npsee_projectile_free(projectile);
}

static void aim(const char* charge, double range_m) {
  npsee_projectile* projectile = NULL;
  npsee_ballistics* ballistics = howitzer(&projectile);
  npsee_target target;
  npsee_solution solution;
  npsee_status status;
  memset(&target, 0, sizeof target);
  target.charge = charge;
  target.range_m = range_m;
  status = npsee_ballistics_aim(ballistics, &target, &solution);
  if (status == NPSEE_NEGATIVE) printf("out of reach: %s\n", npsee_last_error());
  else need(status);
  if (status == NPSEE_OK) printf("elevation_rad %.17g\n", solution.shot.elevation_rad);
  npsee_ballistics_free(ballistics);
  npsee_projectile_free(projectile);
}

static void print_event(void* user, double t_s, const char* kind, const char* json) {
  (void)t_s;
  (void)kind;
  ++*(size_t*)user;
  printf("%s\n", json);
}

static void mission(const char* file) {
  npsee_scenario* scenario = NULL;
  npsee_mission* run = NULL;
  size_t events = 0;
  need(npsee_scenario_load(file, &scenario));
  need(npsee_mission_start(scenario, &run));
  npsee_scenario_free(scenario);
  need(npsee_mission_advance(run, 33.3, print_event, &events));
  need(npsee_mission_advance(run, 1e9, print_event, &events));
  if (!npsee_mission_finished(run) || events != npsee_mission_events(run)) exit(7);
  npsee_mission_free(run);
}

static void print_warning(void* user, double t_s, const char* kind, const char* json) {
  (void)user;
  (void)t_s;
  if (strcmp(kind, "warning") == 0 || strcmp(kind, "call") == 0 || strcmp(kind, "end_of_mission") == 0) printf("%s\n", json);
}

static void orders(const char* file) {
  npsee_scenario* scenario = NULL;
  npsee_mission* run = NULL;
  npsee_order order;
  need(npsee_scenario_load(file, &scenario));
  need(npsee_mission_start(scenario, &run));
  npsee_scenario_free(scenario);
  memset(&order, 0, sizeof order);
  order.kind = NPSEE_TAKE;
  order.who = "fo1";
  need(npsee_mission_order(run, &order));
  order.t_s = 1.0;
  order.kind = NPSEE_CALL_FOR_FIRE;
  order.target = "t72-9";
  need(npsee_mission_order(run, &order));
  order.kind = NPSEE_END_MISSION;
  order.mission = 77;
  need(npsee_mission_order(run, &order));
  order.kind = NPSEE_DRIVE;
  order.who = NULL;
  need(npsee_mission_order(run, &order));
  need(npsee_mission_advance(run, 5.0, print_warning, NULL));
  npsee_mission_free(run);
}

static void record(const char* file, const char* out) {
  npsee_scenario* scenario = NULL;
  npsee_mission* run = NULL;
  need(npsee_scenario_load(file, &scenario));
  need(npsee_mission_start(scenario, &run));
  npsee_scenario_free(scenario);
  need(npsee_mission_advance(run, 1e9, NULL, NULL));
  need(npsee_mission_save(run, out));
  npsee_mission_free(run);
}

/* One line of the log, in a buffer as long as it needs. */
static void print_recorded(const npsee_recording* recording, size_t index) {
  size_t length = 0;
  char* text;
  need(npsee_recording_event(recording, index, NULL, 0, &length));
  text = malloc(length + 1);
  if (text == NULL) exit(6);
  need(npsee_recording_event(recording, index, text, length + 1, NULL));
  printf("event %s\n", text);
  free(text);
}

static void recording(const char* file, double t_s) {
  npsee_recording* kept = NULL;
  npsee_vehicle vehicle;
  npsee_shell shell;
  const char* preset;
  uint64_t seed;
  double height_m;
  size_t i;
  need(npsee_recording_open(file, &kept));
  printf("duration_s %.17g\nhash %s\n", npsee_recording_duration_s(kept), npsee_recording_hash(kept));
  need(npsee_recording_seek(kept, t_s, &i));
  printf("first %d\n", (int)i);
  for (; i < npsee_recording_events(kept); ++i) print_recorded(kept, i);
  for (i = 0; i < npsee_recording_vehicles(kept); ++i) {
    need(npsee_recording_vehicle(kept, i, t_s, &vehicle));
    need(npsee_recording_height(kept, vehicle.position_m[0], vehicle.position_m[2], &height_m));
    printf("vehicle %s %.17g %.17g %.17g %.17g\n", vehicle.id, vehicle.position_m[0], vehicle.position_m[1], vehicle.position_m[2], height_m);
  }
  for (i = 0; i < npsee_recording_shells(kept); ++i) {
    need(npsee_recording_shell(kept, i, t_s, &shell));
    need(npsee_recording_burst(kept, i, &preset, &seed));
    if (shell.in_air) printf("shell %d %.17g %.17g %.17g\n", shell.number, shell.position_m[0], shell.position_m[1], shell.position_m[2]);
    printf("burst %d %.17g %llu %s\n", shell.number, shell.burst_s, (unsigned long long)seed, preset);
  }
  npsee_recording_free(kept);
}

static int refused = 0;

/* The call must fail with this status and leave a text. */
static void refuse(npsee_status status, npsee_status expected, const char* call) {
  if (status != expected || npsee_last_error()[0] == '\0') {
    fprintf(stderr, "%s gave %d instead of %d: %s\n", call, (int)status, (int)expected, npsee_last_error());
    exit(1);
  }
  ++refused;
}
#define REFUSED(status, call) refuse((call), (status), #call)

/* The same, and the handle that was not made is null: to free it is harmless. */
#define NOT_MADE(status, handle, call)                                   \
  do {                                                                   \
    (handle) = (void*)&refused;                                          \
    REFUSED(status, call);                                               \
    if ((handle) != NULL) {                                              \
      fprintf(stderr, "%s leaves a handle that is not one\n", #call);    \
      exit(1);                                                           \
    }                                                                    \
  } while (0)

static const char small[] = "{\"npsee\": 1, \"layers\": [{\"name\": \"a\", \"count\": 5}]}";

static void preset_errors(void) {
  npsee_preset* preset = NULL;
  char text[8];
  size_t length = 0;
  NOT_MADE(NPSEE_USAGE, preset, npsee_preset_load(NULL, &preset));
  REFUSED(NPSEE_USAGE, npsee_preset_load("x", NULL));
  NOT_MADE(NPSEE_INPUT, preset, npsee_preset_load("/nowhere/x.npsee.json", &preset));
  NOT_MADE(NPSEE_USAGE, preset, npsee_preset_parse(NULL, 3, NULL, NULL, &preset));
  NOT_MADE(NPSEE_INPUT, preset, npsee_preset_parse("{", 1, NULL, NULL, &preset));
  need(npsee_preset_parse(small, strlen(small), "small", NULL, &preset));
  REFUSED(NPSEE_USAGE, npsee_preset_set(preset, NULL));
  REFUSED(NPSEE_USAGE, npsee_preset_set(NULL, "seed=1"));
  REFUSED(NPSEE_USAGE, npsee_preset_set(preset, "a.speed_man=4"));
  REFUSED(NPSEE_USAGE, npsee_preset_text(NULL, text, sizeof text, &length));
  REFUSED(NPSEE_USAGE, npsee_preset_text(preset, text, sizeof text, &length));
  REFUSED(NPSEE_USAGE, npsee_preset_text(preset, NULL, 4, &length));
  need(npsee_preset_text(preset, NULL, 0, &length));
  if (length < strlen("{\"npsee\":1}")) exit(1);
  REFUSED(NPSEE_USAGE, npsee_preset_save(preset, NULL));
  REFUSED(NPSEE_OUTPUT, npsee_preset_save(preset, "/nowhere/x.npsee.json"));
  npsee_preset_free(preset);
  npsee_preset_free(NULL);
}

static double nan_heights(void* user, double x_m, double z_m) {
  volatile double zero = 0.0;
  (void)user;
  (void)x_m;
  (void)z_m;
  return zero / zero;
}

/* As a host may mark what it has no data of: the height that `user` points at. */
static double far_heights(void* user, double x_m, double z_m) {
  return x_m + z_m > 0.0 ? *(double*)user : 0.0;
}

/* Whatever the ground is, every number of a frame and of the extent is finite. */
static void need_finite(double ground_m) {
  npsee_preset* preset = NULL;
  npsee_explosion* explosion = NULL;
  npsee_compile_options options = npsee_compile_options_default();
  npsee_frame frame;
  double *columns[7], corners[6];
  size_t i, count;
  int k, step;
  options.ground = far_heights;
  options.ground_user = &ground_m;
  need(npsee_preset_parse(small, strlen(small), "small", NULL, &preset));
  need(npsee_preset_set(preset, "a.count=60"));
  need(npsee_explosion_compile(preset, &options, &explosion));
  count = npsee_explosion_particles(explosion);
  for (k = 0; k < 7; ++k) columns[k] = column(count);
  memset(&frame, 0, sizeof frame);
  frame.capacity = count;
  frame.x = columns[0];
  frame.y = columns[1];
  frame.z = columns[2];
  frame.vx = columns[3];
  frame.vy = columns[4];
  frame.vz = columns[5];
  frame.size = columns[6];
  need(npsee_explosion_extent(explosion, corners, corners + 3));
  for (k = 0; k < 6; ++k)
    if (!(corners[k] > -1e9 && corners[k] < 1e9)) exit(1);
  for (step = 0; step < 30; ++step) {
    need(npsee_explosion_at(explosion, 0.2 * step, &frame, 1));
    for (i = 0; i < count; ++i)
      for (k = 0; k < 7; ++k)
        if (!(columns[k][i] > -1e9 && columns[k][i] < 1e9)) {
          fprintf(stderr, "on a ground of %g m particle %d has %g\n", ground_m, (int)i, columns[k][i]);
          exit(1);
        }
  }
  for (k = 0; k < 7; ++k) free(columns[k]);
  npsee_explosion_free(explosion);
  npsee_preset_free(preset);
}

/* What a thread keeps between calls is given back: the memory in use is the same again. Sanitizers count none. */
static void need_scratch_released(void) {
  npsee_preset* preset = NULL;
  npsee_explosion* explosion = NULL;
  size_t used[2] = {0, 0};
  int round;
  need(npsee_preset_parse(small, strlen(small), "small", NULL, &preset));
  need(npsee_preset_set(preset, "a.count=2000"));
  for (round = 0; round < 2; ++round) {
    need(npsee_explosion_compile(preset, NULL, &explosion));
    npsee_explosion_free(explosion);
    if (round == 1) used[0] = mallinfo2().uordblks;
    npsee_release_scratch();
    if (round == 1) used[1] = mallinfo2().uordblks;
  }
  if (used[0] != 0 && used[1] + 1000 > used[0]) {
    fprintf(stderr, "compiling keeps its room: %lu and %lu bytes\n", (unsigned long)used[0], (unsigned long)used[1]);
    exit(1);
  }
  npsee_preset_free(preset);
}

static void explosion_errors(void) {
  npsee_preset* preset = NULL;
  npsee_explosion* explosion = NULL;
  npsee_compile_options options = npsee_compile_options_default();
  npsee_frame frame;
  npsee_layer layer;
  double corner[3], zero = 0.0, numbers[5];
  need(npsee_preset_parse(small, strlen(small), "small", NULL, &preset));
  NOT_MADE(NPSEE_USAGE, explosion, npsee_explosion_compile(NULL, NULL, &explosion));
  REFUSED(NPSEE_USAGE, npsee_explosion_compile(preset, NULL, NULL));
  options.max_particles = 4;
  NOT_MADE(NPSEE_INPUT, explosion, npsee_explosion_compile(preset, &options, &explosion));
  options.max_particles = 0;
  options.max_bytes = 100;
  NOT_MADE(NPSEE_INPUT, explosion, npsee_explosion_compile(preset, &options, &explosion));
  options.max_bytes = 0;
  options.threads = 0;
  NOT_MADE(NPSEE_USAGE, explosion, npsee_explosion_compile(preset, &options, &explosion));
  options.threads = 1;
  options.ground = nan_heights;
  options.ground_detail_m = 0.0;
  NOT_MADE(NPSEE_USAGE, explosion, npsee_explosion_compile(preset, &options, &explosion));
  options.ground_detail_m = 1.0;
  need(npsee_explosion_compile(preset, &options, &explosion));
  memset(&frame, 0, sizeof frame);
  frame.capacity = 4;
  REFUSED(NPSEE_USAGE, npsee_explosion_at(explosion, 0.5, &frame, 1));
  frame.capacity = 5;
  REFUSED(NPSEE_USAGE, npsee_explosion_at(explosion, 1.0 / zero, &frame, 1));
  REFUSED(NPSEE_USAGE, npsee_explosion_at(explosion, 0.5, &frame, 0));
  REFUSED(NPSEE_USAGE, npsee_explosion_at(explosion, 0.5, NULL, 1));
  REFUSED(NPSEE_USAGE, npsee_explosion_at(NULL, 0.5, &frame, 1));
  REFUSED(NPSEE_USAGE, npsee_explosion_at_float(explosion, 0.5, NULL, 1));
  REFUSED(NPSEE_USAGE, npsee_explosion_layer(explosion, 1, &layer));
  REFUSED(NPSEE_USAGE, npsee_explosion_layer(explosion, 0, NULL));
  REFUSED(NPSEE_USAGE, npsee_explosion_extent(explosion, corner, NULL));
  /* No array at all, and a single one, are both fine. */
  need(npsee_explosion_at(explosion, 0.5, &frame, 1));
  frame.y = numbers;
  need(npsee_explosion_at(explosion, 0.5, &frame, 3));
  if (npsee_explosion_particles(NULL) != 0 || npsee_explosion_particles(explosion) != 5) exit(1);
  need(npsee_explosion_layer(explosion, 0, &layer));
  if (strcmp(layer.name, "a") != 0 || strcmp(layer.form, "tetrahedron") != 0 || layer.count != 5) exit(1);
  npsee_explosion_free(explosion);
  npsee_explosion_free(NULL);
  npsee_preset_free(preset);
}

static void flight_errors(void) {
  npsee_projectile* projectile = NULL;
  npsee_ballistics* ballistics = NULL;
  npsee_conditions conditions = npsee_conditions_default();
  npsee_shot shot;
  npsee_flight flight;
  npsee_path* path = NULL;
  npsee_target target;
  npsee_solution solution;
  double zero = 0.0;
  NOT_MADE(NPSEE_USAGE, projectile, npsee_projectile_find("m108", &projectile));
  NOT_MADE(NPSEE_USAGE, projectile, npsee_projectile_find(NULL, &projectile));
  NOT_MADE(NPSEE_INPUT, projectile, npsee_projectile_parse("[]", 2, "x", &projectile));
  need(npsee_projectile_find("m107", &projectile));
  REFUSED(NPSEE_USAGE, npsee_projectile_set(projectile, "weight=3"));
  REFUSED(NPSEE_USAGE, npsee_projectile_shot(projectile, "99", 0.5, &shot));
  REFUSED(NPSEE_USAGE, npsee_projectile_charge(projectile, 1000, NULL, NULL));
  conditions.model = "magic";
  NOT_MADE(NPSEE_USAGE, ballistics, npsee_ballistics_make(projectile, &conditions, &ballistics));
  conditions.model = NULL;
  conditions.tolerance_m = zero / zero;
  NOT_MADE(NPSEE_USAGE, ballistics, npsee_ballistics_make(projectile, &conditions, &ballistics));
  need(npsee_ballistics_make(projectile, NULL, &ballistics));
  need(npsee_projectile_shot(projectile, NULL, 0.5, &shot));
  shot.speed_mps = zero / zero;
  REFUSED(NPSEE_USAGE, npsee_ballistics_fly(ballistics, &shot, &flight));
  NOT_MADE(NPSEE_USAGE, path, npsee_ballistics_path(ballistics, &shot, &path));
  REFUSED(NPSEE_USAGE, npsee_path_at(NULL, 0.0, 0, NULL, NULL, NULL));
  REFUSED(NPSEE_USAGE, npsee_ballistics_fly(ballistics, NULL, &flight));
  memset(&target, 0, sizeof target);
  REFUSED(NPSEE_USAGE, npsee_ballistics_aim(ballistics, &target, &solution));
  target.charge = "7W";
  REFUSED(NPSEE_USAGE, npsee_ballistics_aim(ballistics, &target, &solution));
  target.range_m = zero / zero;
  REFUSED(NPSEE_USAGE, npsee_ballistics_aim(ballistics, &target, &solution));
  target.range_m = 1e6;
  REFUSED(NPSEE_NEGATIVE, npsee_ballistics_aim(ballistics, &target, &solution));
  /* Too high is out of reach as well; a height that cannot be is a mistake. */
  target.range_m = 5000.0;
  target.height_m = 15000.0;
  REFUSED(NPSEE_NEGATIVE, npsee_ballistics_aim(ballistics, &target, &solution));
  if (strstr(npsee_last_error(), "15000 m above the muzzle") == NULL) exit(1);
  target.height_m = 30000.0;
  REFUSED(NPSEE_USAGE, npsee_ballistics_aim(ballistics, &target, &solution));
  target.height_m = zero / zero;
  REFUSED(NPSEE_USAGE, npsee_ballistics_aim(ballistics, &target, &solution));
  npsee_ballistics_free(ballistics);
  npsee_ballistics_free(NULL);
  npsee_path_free(NULL);
  npsee_projectile_free(projectile);
  npsee_projectile_free(NULL);
}

static void mission_errors(void) {
  npsee_scenario* scenario = NULL;
  npsee_mission* run = NULL;
  npsee_order order;
  npsee_vehicle vehicle;
  npsee_shell shell;
  char text[4];
  double zero = 0.0;
  static const char file[] = "{\"npsee_mission\": 1, \"name\": \"x\", \"duration\": 1}";
  NOT_MADE(NPSEE_USAGE, scenario, npsee_scenario_load(NULL, &scenario));
  NOT_MADE(NPSEE_INPUT, scenario, npsee_scenario_load("/nowhere.mission.json", &scenario));
  NOT_MADE(NPSEE_INPUT, scenario, npsee_scenario_parse("[", 1, NULL, NULL, &scenario));
  NOT_MADE(NPSEE_USAGE, run, npsee_mission_start(NULL, &run));
  need(npsee_scenario_parse(file, strlen(file), "x", NULL, &scenario));
  REFUSED(NPSEE_USAGE, npsee_scenario_set(scenario, "nothing=1"));
  need(npsee_mission_start(scenario, &run));
  REFUSED(NPSEE_USAGE, npsee_mission_advance(NULL, 1.0, NULL, NULL));
  REFUSED(NPSEE_USAGE, npsee_mission_advance(run, zero / zero, NULL, NULL));
  memset(&order, 0, sizeof order);
  REFUSED(NPSEE_USAGE, npsee_mission_order(run, NULL));
  order.x_m = zero / zero;
  REFUSED(NPSEE_USAGE, npsee_mission_order(run, &order));
  order.x_m = 0.0;
  order.kind = 99;
  REFUSED(NPSEE_USAGE, npsee_mission_order(run, &order));
  REFUSED(NPSEE_USAGE, npsee_mission_event(run, 1000000, text, sizeof text, NULL));
  REFUSED(NPSEE_USAGE, npsee_mission_vehicle(run, 1000000, 0.0, &vehicle));
  REFUSED(NPSEE_USAGE, npsee_mission_shell(run, 1000000, 0.0, &shell));
  REFUSED(NPSEE_USAGE, npsee_mission_save(run, "/nowhere/x.rec"));
  need(npsee_mission_advance(run, 10.0, NULL, NULL));
  REFUSED(NPSEE_OUTPUT, npsee_mission_save(run, "/nowhere/x.rec"));
  npsee_mission_free(run);
  npsee_mission_free(NULL);
  npsee_scenario_free(scenario);
  npsee_scenario_free(NULL);
}

static void recording_errors(const char* file) {
  npsee_recording* kept = NULL;
  npsee_vehicle vehicle;
  npsee_shell shell;
  char text[4];
  size_t index = 0;
  double zero = 0.0, height_m;
  NOT_MADE(NPSEE_USAGE, kept, npsee_recording_open(NULL, &kept));
  REFUSED(NPSEE_USAGE, npsee_recording_open(file, NULL));
  NOT_MADE(NPSEE_INPUT, kept, npsee_recording_open("/nowhere/x.rec", &kept));
  need(npsee_recording_open(file, &kept));
  REFUSED(NPSEE_USAGE, npsee_recording_event(NULL, 0, NULL, 0, NULL));
  REFUSED(NPSEE_USAGE, npsee_recording_event(kept, 1000000, NULL, 0, NULL));
  REFUSED(NPSEE_USAGE, npsee_recording_event(kept, 0, text, sizeof text, NULL));
  REFUSED(NPSEE_USAGE, npsee_recording_event_kind(kept, 1000000, NULL, NULL));
  REFUSED(NPSEE_USAGE, npsee_recording_seek(kept, zero / zero, &index));
  REFUSED(NPSEE_USAGE, npsee_recording_seek(kept, 0.0, NULL));
  REFUSED(NPSEE_USAGE, npsee_recording_vehicle(kept, 1000000, 0.0, &vehicle));
  REFUSED(NPSEE_USAGE, npsee_recording_vehicle(kept, 0, 1.0 / zero, &vehicle));
  REFUSED(NPSEE_USAGE, npsee_recording_vehicle(kept, 0, 0.0, NULL));
  REFUSED(NPSEE_USAGE, npsee_recording_shell(kept, 1000000, 0.0, &shell));
  REFUSED(NPSEE_USAGE, npsee_recording_burst(kept, 1000000, NULL, NULL));
  REFUSED(NPSEE_USAGE, npsee_recording_height(kept, 1.0 / zero, 0.0, &height_m));
  REFUSED(NPSEE_USAGE, npsee_recording_unmet(NULL, NULL, 0, NULL));
  /* Beyond both ends. */
  need(npsee_recording_seek(kept, -1.0, &index));
  if (index != 0) exit(1);
  need(npsee_recording_seek(kept, 1.0 / zero, &index));
  if (index != npsee_recording_events(kept) || npsee_recording_events(NULL) != 0 || npsee_recording_hash(NULL)[0] != '\0') exit(1);
  need(npsee_recording_vehicle(kept, 0, 1e300, &vehicle));
  npsee_recording_free(kept);
  npsee_recording_free(NULL);
}

int main(int argc, char** argv) {
  if (npsee_abi() != NPSEE_ABI || npsee_last_error()[0] != '\0') return 1;
  if (argc >= 5 && strcmp(argv[1], "particles") == 0) particles(argv[2], atof(argv[3]), atoi(argv[4]), argc > 5 ? argv[5] : NULL);
  else if (argc == 4 && strcmp(argv[1], "fly") == 0) fly(argv[2], atof(argv[3]));
  else if (argc == 4 && strcmp(argv[1], "aim") == 0) aim(argv[2], atof(argv[3]));
  else if (argc == 3 && strcmp(argv[1], "mission") == 0) mission(argv[2]);
  else if (argc == 3 && strcmp(argv[1], "orders") == 0) orders(argv[2]);
  else if (argc == 4 && strcmp(argv[1], "record") == 0) record(argv[2], argv[3]);
  else if (argc == 4 && strcmp(argv[1], "recording") == 0) recording(argv[2], atof(argv[3]));
  else if (argc == 3 && strcmp(argv[1], "errors") == 0) {
    preset_errors();
    explosion_errors();
    need_scratch_released();
    need_finite(1e7);
    need_finite(-1e7);
    need_finite(1e39);
    need_finite(-1e300);
    flight_errors();
    mission_errors();
    recording_errors(argv[2]);
    printf("refused %d\n", refused);
  } else return 2;
  return 0;
}
