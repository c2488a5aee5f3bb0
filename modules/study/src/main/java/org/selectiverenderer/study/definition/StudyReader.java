package org.selectiverenderer.study.definition;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfileLoader;
import org.selectiverenderer.apparatus.EyeGeometry;
import org.selectiverenderer.apparatus.MouseButtonMapping;
import org.selectiverenderer.base.decimal.Pluralizer;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.json.JsonObjectReader;
import org.selectiverenderer.formats.json.JsonSettingsReader;
import org.selectiverenderer.formats.json.LocatedJsonValue;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.schema.SwitchTransition;
import org.selectiverenderer.study.design.StudyDesign;
import org.selectiverenderer.study.design.StudyGroup;
import org.selectiverenderer.study.questionnaire.read.LocalizedTexts;
import org.selectiverenderer.tracker.TrackerSpec;
import org.selectiverenderer.x3d.url.ContentAccessKeys;
import org.selectiverenderer.x3d.url.NetworkShare;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Reads a study file. Every fault (an unknown key, an invalid value, a missing file) is an error
 * with line and column, and a study with faults is not used: a session never runs with a part of
 * the intended settings.
 */
public final class StudyReader {
  /** Upper limit of participants; a greater number is a typing error. */
  private static final int MOST_PARTICIPANTS = 100_000;

  private static final double LONGEST = 36_000;

  /** Name of an X3D file in the text of another one. */
  private static final Pattern FILE = Pattern.compile("[\\w][\\w ./-]{0,200}\\.x3d\\b");

  /** Number of inlined files in which a name is looked for. */
  private static final int MOST_INLINED = 500;

  private static final JsonSettingsReader JSON =
      new JsonSettingsReader("a study", "the study is not used");
  private static final String LABEL = "[0-9A-Za-z]+";

  /** Pattern of the languages of a study of several, which become names of files and columns. */
  private static final String LANGUAGE = "[A-Za-z]{2,3}([_-][0-9A-Za-z]{1,8}){0,3}";

  private final Path file;
  private final Path folder;
  private final Optional<String> asked;
  private final ProblemCollector problems;

  private StudyReader(Path file, Optional<String> asked, ProblemCollector problems) {
    this.file = file;
    this.asked = asked;
    this.problems = problems;
    folder = file.toAbsolutePath().getParent();
  }

  /**
   * Reads a file of one's own, and the text of its scenes for the DEFs that it names.
   *
   * @return empty if the file has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<Study> read(Path file, ProblemCollector problems) throws IOException {
    return read(file, Optional.empty(), study -> true, problems);
  }

  /**
   * Reads a file.
   *
   * @param language one of the study's languages, in which its texts are needed; empty for the
   *     first
   * @param check is called before any other file is read, if there are no faults so far; it throws
   *     an exception if the study must not have what it asks for, and returns whether the text of
   *     scenes outside of the study's folder and project may be read
   * @return empty if the file has faults, which are then in {@code problems}
   * @throws IOException if the file cannot be read
   */
  public static Optional<Study> read(
      Path file, Optional<String> language, Predicate<Study> check, ProblemCollector problems)
      throws IOException {
    ProblemCollector faults = new ProblemCollector(problems::add);
    StudyReader reader = new StudyReader(file, language, faults);
    return JSON.read(
            file,
            faults,
            keys -> {
              Study study = reader.study(keys);
              boolean all = !faults.any() && check.test(study);
              UrlResolver own = new UrlResolver(study.folder());
              viewpoints(keys, study, scene -> all || own.mayBeNamed(scene));
              new TrialChecker(
                      study,
                      (scene, name) -> (all || own.mayBeNamed(scene)) && lacks(scene, name),
                      (scene, name) ->
                          (all || own.mayBeNamed(scene)) && lacksWithInlines(scene, name))
                  .check(fault -> keys.fault("blocks", fault));
              return study;
            })
        // Tables that the file names report faults of their own places.
        .filter(study -> !faults.anyError());
  }

  private Study study(JsonObjectReader keys) {
    List<Study.Area> areas = areas(keys);
    Optional<Path> scene =
        keys.text("scene", !areas.isEmpty() && !keys.has("blocks"))
            .map(name -> file(keys, "scene", name));
    List<String> languages = languages(keys);
    String language = asked.filter(languages::contains).orElse(languages.get(0));
    StudyDesign design =
        new StudyDesignReader(this::file, new LocalizedTexts(language, languages), problems)
            .read(keys, conditions(keys));
    int participants = (int) keys.whole("participants", 1, MOST_PARTICIPANTS, Double.NaN);
    int groups = design.groups().size();
    if (participants < groups) {
      keys.fault(
          "participants",
          "%s %s fewer than the %d groups"
              .formatted(
                  Pluralizer.of(participants, "participant"),
                  participants == 1 ? "is" : "are",
                  groups));
    }
    int block = (int) keys.whole("block", 1, MOST_PARTICIPANTS, groups);
    if (block % groups != 0) {
      keys.fault(
          "block",
          "a block of %d participants cannot contain %d groups equally often"
              .formatted(block, groups));
    }
    ConditionAssignment assignment =
        keys.choice(
            "assignment",
            List.of(ConditionAssignment.values()),
            ConditionAssignment::spelling,
            ConditionAssignment.BLOCKED);
    if (assignment == ConditionAssignment.LATIN_SQUARE && block != groups) {
      keys.fault(
          "block",
          "a Latin square of %d groups needs blocks of %d, not of %d"
              .formatted(groups, groups, block));
    }
    Study study =
        new Study(
            file,
            keys.text("name"),
            scene,
            design,
            participants,
            assignment,
            block,
            keys.whole("seed", 0, 1L << 53, 0),
            practice(keys),
            areas,
            keys.number("fade", 0, 60, 1),
            display(keys),
            tracker(keys),
            keys.choice(
                "mouse",
                List.of(MouseButtonMapping.values()),
                mapping -> mapping.name().toLowerCase(Locale.ROOT),
                MouseButtonMapping.EXPERIMENT),
            language,
            languages,
            new StudyQuestionnairesReader(this::file)
                .read(keys, !areas.isEmpty(), keys.has("practice")),
            QualityCriteriaReader.read(keys),
            StudyProcedureReader.read(keys),
            StudyStreamsReader.read(keys),
            ContentAccessKeys.of(keys, file.toAbsolutePath()),
            keys.truth("mute", false),
            TriggerSettingsReader.read(keys, design),
            TrialSettingsReader.transition(keys).orElse(SwitchTransition.AT_ONCE),
            TrialSettingsReader.qualities(keys));
    if (areas.isEmpty() && design.blocks().isEmpty() && study.questionnaires().list().isEmpty()) {
      keys.fault(
          "the study has neither areas nor blocks nor questionnaires, so there is nothing to do");
    }
    return study;
  }

  private List<String> languages(JsonObjectReader keys) {
    String one = keys.text("language", false).orElse("en");
    if (!keys.has("languages")) {
      requireAsked(keys, "language", List.of(one));
      return List.of(one);
    }
    if (keys.has("language")) {
      keys.fault("language", "a study has either \"language\" or \"languages\"");
    }
    List<String> languages = new ArrayList<>();
    for (LocatedJsonValue value : keys.list("languages", false)) {
      String code = value.text().orElse("");
      if (!code.matches(LANGUAGE)) {
        keys.fault(value, "a language is a code such as \"en\" or \"el\"");
      } else if (languages.contains(code)) {
        keys.fault(value, "the language " + code + " is listed twice");
      } else {
        languages.add(code);
      }
    }
    if (languages.isEmpty()) {
      keys.fault("languages", "a study needs at least one language");
      return List.of(one);
    }
    requireAsked(keys, "languages", languages);
    return languages;
  }

  private void requireAsked(JsonObjectReader keys, String key, List<String> languages) {
    if (asked.isPresent() && !languages.contains(asked.get())) {
      keys.fault(
          keys.has(key) ? key : "name",
          "the study has no language '%s', only %s"
              .formatted(asked.get(), String.join(", ", languages)));
    }
  }

  /**
   * Checks that the text of the scene contains the DEFs of viewpoints and areas, so that a missing
   * one is found before the session.
   *
   * @param readable which scenes may be read
   */
  private static void viewpoints(JsonObjectReader keys, Study study, Predicate<Path> readable) {
    study
        .scene()
        .filter(readable)
        .ifPresent(
            scene ->
                study.areas().stream()
                    .filter(area -> !area.viewpoint().isEmpty() && lacks(scene, area.viewpoint()))
                    .forEach(
                        area ->
                            keys.fault(
                                "areas",
                                "the scene has no Viewpoint with the DEF '%s', which the area %s"
                                        .formatted(area.viewpoint(), area.name())
                                    + " needs")));
    study
        .scene()
        .filter(readable)
        .ifPresent(
            scene ->
                study.areas().stream()
                    .filter(area -> area.within().filter(def -> lacks(scene, def)).isPresent())
                    .forEach(
                        area ->
                            keys.fault(
                                "areas",
                                ("the scene has no ProximitySensor and no group with the DEF '%s',"
                                        + " within which the area %s lies")
                                    .formatted(area.within().orElse(""), area.name()))));
    study
        .practice()
        .filter(practice -> readable.test(practice.scene()))
        .filter(practice -> !practice.viewpoint().isEmpty())
        .filter(practice -> lacks(practice.scene(), practice.viewpoint()))
        .ifPresent(
            practice ->
                keys.fault(
                    "practice",
                    "the practice scene has no Viewpoint with the DEF '%s'"
                        .formatted(practice.viewpoint())));
  }

  private static boolean lacks(Path scene, String viewpoint) {
    if (!scene.toString().endsWith(".x3d") || !Files.isRegularFile(scene)) {
      return false;
    }
    try {
      String text = new String(InputFileReader.bytes(scene), StandardCharsets.ISO_8859_1);
      String name =
          new String(viewpoint.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1);
      return !text.contains("'" + name + "'") && !text.contains('"' + name + '"');
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Returns whether neither a scene nor the X3D files below its folder that it names have a DEF.
   */
  private static boolean lacksWithInlines(Path scene, String name) {
    Deque<Path> open = new ArrayDeque<>(List.of(scene));
    Set<Path> seen = new HashSet<>(open);
    while (!open.isEmpty()) {
      Path file = open.pop();
      if (!lacks(file, name)) {
        return false;
      }
      for (Path inlined : inlined(file)) {
        boolean below = inlined.startsWith(scene.toAbsolutePath().normalize().getParent());
        if (below && seen.size() < MOST_INLINED && seen.add(inlined)) {
          open.push(inlined);
        }
      }
    }
    return true;
  }

  private static List<Path> inlined(Path scene) {
    try {
      String text = new String(InputFileReader.bytes(scene), StandardCharsets.ISO_8859_1);
      return FILE.matcher(text)
          .results()
          .map(found -> scene.toAbsolutePath().resolveSibling(found.group()).normalize())
          .filter(Files::isRegularFile)
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Path file(JsonObjectReader keys, String key, String name) {
    if (NetworkShare.is(name)) {
      keys.fault(key, "'" + name + "' is on another computer; name a file of this one");
      return file;
    }
    Path found = folder.resolve(name).normalize();
    if (!Files.isRegularFile(found)) {
      keys.fault(key, "there is no file '" + name + "' relative to the study file");
    }
    return found;
  }

  private List<StudyGroup> conditions(JsonObjectReader keys) {
    List<Condition> conditions = new ArrayList<>();
    for (LocatedJsonValue value : keys.list("conditions", !keys.has("factors"))) {
      Optional<Condition> found = Condition.of(value.toString());
      if (found.isEmpty()) {
        keys.fault(
            value,
            "'%s' is not a condition (high, high-low, selective or random)".formatted(value));
      } else if (conditions.contains(found.get())) {
        keys.fault(value, "the condition %s is named twice".formatted(value));
      } else {
        conditions.add(found.get());
      }
    }
    if (conditions.isEmpty() && keys.has("conditions")) {
      keys.fault("conditions", "a study needs at least one condition");
    }
    return conditions.stream().map(StudyGroup::of).toList();
  }

  private Optional<Study.Practice> practice(JsonObjectReader keys) {
    return keys.object(
        "practice",
        "practice",
        practice ->
            new Study.Practice(
                file(practice, "scene", practice.text("scene")),
                practice.text("viewpoint", false).orElse("")));
  }

  private List<Study.Area> areas(JsonObjectReader keys) {
    Set<String> names = new HashSet<>();
    return keys.objects(
        "areas",
        "an area",
        area -> {
          String name = area.text("name");
          if (!name.matches(LABEL)) {
            area.fault("name", "an area's name must consist of letters and digits");
          } else if (!names.add(name.toLowerCase(Locale.ROOT))) {
            area.fault("name", "the area " + name + " is named twice");
          }
          String viewpoint = area.text("viewpoint");
          double seconds = area.number("seconds", 0.1, LONGEST, Double.NaN);
          return new Study.Area(
              name,
              viewpoint,
              seconds,
              StudyProcedureReader.stay(area),
              area.text("within", false));
        });
  }

  private Study.Display display(JsonObjectReader keys) {
    return keys.object("display", "the display", this::shown)
        .orElse(
            new Study.Display(
                DisplayMode.WINDOW,
                "desk",
                EyeGeometry.MEAN_IPD,
                0,
                0,
                Optional.empty(),
                PointerConfinement.AUTO,
                Study.Worn.STANDING));
  }

  private Study.Display shown(JsonObjectReader display) {
    DisplayMode mode =
        display.choice(
            "mode",
            List.of(DisplayMode.values()),
            value -> value.name().toLowerCase(Locale.ROOT).replace('_', '-'),
            DisplayMode.WINDOW);
    String hmd =
        display
            .text("hmd", false)
            .map(
                name ->
                    DisplayProfileLoader.builtIn(name).isPresent()
                        ? name
                        : file(display, "hmd", name).toString())
            .orElse(mode == DisplayMode.WINDOW ? "desk" : "proview50");
    double ipd = display.number("ipd", 0, EyeGeometry.LARGEST_IPD, EyeGeometry.MEAN_IPD);
    int width = (int) display.whole("width", 64, 16384, 0);
    int height = (int) display.whole("height", 64, 16384, 0);
    return new Study.Display(
        mode,
        hmd,
        ipd,
        width,
        height,
        StudyProcedureReader.operator(display),
        StudyProcedureReader.pointer(display),
        worn(display, mode));
  }

  private static Study.Worn worn(JsonObjectReader display, DisplayMode mode) {
    for (String key : List.of("posture", "user_scale", "turn", "questions")) {
      if (display.has(key) && mode != DisplayMode.OPENXR) {
        display.fault(key, "\"%s\" needs \"mode\": \"openxr\"".formatted(key));
      }
    }
    boolean seated =
        display.choice(
            "posture", List.of(false, true), each -> each ? "seated" : "standing", false);
    return new Study.Worn(
        seated,
        display.number("user_scale", 0.01, 100, Study.Worn.STANDING.scale()),
        display.number("turn", 0, 180, Study.Worn.STANDING.turn()),
        display.choice(
            "questions", List.of(false, true), each -> each ? "headset" : "desk", false));
  }

  private TrackerSpec tracker(JsonObjectReader keys) {
    String spec = keys.text("tracker", false).orElse("none");
    try {
      TrackerSpec tracker = TrackerSpec.parse(spec);
      if (tracker instanceof TrackerSpec.Replay) {
        keys.fault(
            "tracker", "a recording cannot be the tracker of a session; name a tracker or none");
      }
      return tracker;
    } catch (IllegalArgumentException e) {
      keys.fault("tracker", String.valueOf(e.getMessage()));
      return new TrackerSpec.None();
    }
  }

  /** Reads the key {@code streams} of a study. */
  private static final class StudyStreamsReader {
    private StudyStreamsReader() {}

    static LslSettings read(JsonObjectReader study) {
      return study
          .object("streams", "the streams", StudyStreamsReader::streams)
          .orElse(LslSettings.NONE);
    }

    private static LslSettings streams(JsonObjectReader keys) {
      for (LocatedJsonValue condition : keys.list("record", false)) {
        if (condition.text().isPresent() && condition.text().get().isBlank()) {
          keys.fault(condition, "a condition such as \"type='EEG'\" is needed, not an empty text");
        }
      }
      return new LslSettings(keys.truth("lsl", false), keys.texts("record"));
    }
  }
}
