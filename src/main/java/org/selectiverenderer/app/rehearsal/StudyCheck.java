package org.selectiverenderer.app.rehearsal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import org.selectiverenderer.app.narration.Narration;
import org.selectiverenderer.apparatus.DisplayMode;
import org.selectiverenderer.apparatus.DisplayProfileLoader;
import org.selectiverenderer.base.files.InputFileReader;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.base.problem.SpellingSuggester;
import org.selectiverenderer.browser.sound.SoundDevices;
import org.selectiverenderer.formats.csv.CsvRow;
import org.selectiverenderer.formats.csv.CsvTable;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.definition.StudyQuestionnaires.Content;
import org.selectiverenderer.study.design.StimulusList;
import org.selectiverenderer.study.design.TrialBlock;
import org.selectiverenderer.study.questionnaire.ItemQuestionnaireKind;
import org.selectiverenderer.study.questionnaire.ParticipantMessages;
import org.selectiverenderer.study.rehearsal.StudyDuration;
import org.selectiverenderer.study.session.DiskRoom;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.study.session.StudyPlan;
import org.selectiverenderer.walkthrough.Walkthrough;

/**
 * What a check has found out about a study, besides its findings.
 *
 * @param polygons polygons of what participants see at the begin of exposures, by its description
 * @param left number of further views, whose scenes were not loaded
 * @param free free bytes of the disk with the study's folder
 */
public record StudyCheck(
    LoadedStudy material,
    StudyPlan plan,
    StudyDuration duration,
    Map<String, Long> polygons,
    int left,
    long free) {
  /** Number of views whose scenes are loaded. */
  static final int MOST_VIEWS = 40;

  /** Column of an items table with the DEF of the object in the scene. */
  static final String SCENE_OBJECT = "scene_object";

  /**
   * Checks a study that has been read.
   *
   * @param problems receives the findings
   * @throws IOException if a file that was there is not to be read
   */
  public static StudyCheck of(LoadedStudy material, ProblemCollector problems) throws IOException {
    return of(List.of(material), problems);
  }

  /**
   * Checks a study that has been read in all of its languages.
   *
   * @param translations the study in each language
   * @param problems receives the findings
   * @throws IOException if a file that was there is not to be read
   */
  public static StudyCheck of(List<LoadedStudy> translations, ProblemCollector problems)
      throws IOException {
    LoadedStudy material = translations.get(0);
    audio(translations, problems);
    Study study = material.study();
    StudyPlan plan = StudyPlan.of(study, Math.min(10_000, study.participants()));
    SourceLocation whole = SourceLocation.of(study.file().toString());
    material.lackingScene().ifPresent(sentence -> problems.error(whole, sentence));
    plan.faults().forEach(fault -> problems.error(whole, fault));
    if (study.display().mode() != DisplayMode.OPENXR
        && DisplayProfileLoader.builtIn(study.display().hmd()).isEmpty()) {
      DisplayProfileLoader.read(Path.of(study.display().hmd()), problems);
    }
    for (String language : study.languages()) {
      Optional<ParticipantMessages> words =
          ParticipantMessages.of(language, study.folder(), problems);
      List<String> missing = words.map(ParticipantMessages::untranslated).orElse(List.of());
      if (!missing.isEmpty() && !language.equals("en")) {
        problems.warning(
            SourceLocation.of(ParticipantMessages.file(language, study.folder()).toString()),
            "%s in the language '%s', as %s; English stands in"
                .formatted(
                    missing.size() == 1
                        ? "a text of the program is missing"
                        : missing.size() + " texts of the program are missing",
                    language,
                    missing.get(0)));
      }
    }
    DiskRoom room = DiskRoom.of(study);
    room.warning().ifPresent(sentence -> problems.warning(whole, sentence));
    if (!Files.isWritable(study.folder())) {
      problems.error(whole, "the study's folder cannot be written, so no session can be kept");
    }
    Checker checker = new Checker(study, problems);
    List<StudyView> views = StudyView.of(study);
    for (StudyView view : views) {
      checker.names(view);
    }
    checker.items();
    Map<String, Long> polygons = checker.load(views);
    return new StudyCheck(
        material,
        plan,
        StudyDuration.of(material, StudyDuration.Assumptions.USUAL),
        polygons,
        Math.max(0, views.size() - MOST_VIEWS),
        room.free());
  }

  /** Checks that the sound files of all languages can be played. */
  private static void audio(List<LoadedStudy> translations, ProblemCollector problems) {
    Set<Path> files = new LinkedHashSet<>();
    translations.forEach(one -> files.addAll(one.audio()));
    for (Path file : files) {
      SourceLocation at = SourceLocation.of(file.toString());
      try {
        if (Narration.read(file, new AtomicLong(Long.MAX_VALUE)).isEmpty()) {
          problems.error(at, "the audio has a format that cannot be played; use WAV or MP3");
        }
      } catch (IOException e) {
        problems.error(at, "the audio " + e.getMessage());
      }
    }
    if (!files.isEmpty() && SoundDevices.names().isEmpty()) {
      problems.info(
          SourceLocation.of(translations.get(0).study().file().toString()),
          "the study has audio, and this computer has no sound device");
    }
  }

  private static final class Checker {
    private final Study study;
    private final ProblemCollector problems;
    private final Map<Path, Optional<SceneNames>> scenes = new HashMap<>();
    private final Set<String> told = new HashSet<>();
    private final String text;

    Checker(Study study, ProblemCollector problems) throws IOException {
      this.study = study;
      this.problems = problems;
      text = InputFileReader.text(study.file());
    }

    private Optional<SceneNames> scene(Path file) {
      return scenes.computeIfAbsent(
          file,
          first -> {
            try {
              return Optional.of(SceneNames.of(first, study.access()));
            } catch (IOException e) {
              problems.error(
                  at(String.valueOf(first.getFileName())),
                  "the scene cannot be read (%s)".formatted(e.getMessage()));
              return Optional.empty();
            }
          });
    }

    /** Returns where the study file first has a text between quotation marks, else the file. */
    private SourceLocation at(String quoted) {
      int found = text.indexOf('"' + quoted + '"');
      if (found < 0) {
        return SourceLocation.of(study.file().toString());
      }
      String before = text.substring(0, found);
      int line = (int) before.chars().filter(c -> c == '\n').count() + 1;
      return new SourceLocation(study.file().toString(), line, found - before.lastIndexOf('\n'));
    }

    /**
     * Returns where a name comes from: the study file, the stimulus that has it as a cell, else the
     * step in the study file.
     */
    private SourceLocation source(String name, String step) {
      SourceLocation here = at(name);
      if (here.line() > 0) {
        return here;
      }
      for (TrialBlock block : study.design().blocks()) {
        if (block.name().equals(step) && block.stimuli().isPresent()) {
          for (StimulusList.Stimulus row : block.stimuli().get().rows()) {
            if (row.cells().containsValue(name)) {
              return new SourceLocation(block.stimuli().get().file().toString(), row.line(), 1);
            }
          }
        }
      }
      return at(step);
    }

    private void tell(SourceLocation at, String sentence) {
      if (told.add(at + sentence)) {
        problems.error(at, sentence);
      }
    }

    void names(StudyView view) {
      Optional<SceneNames> found = scene(view.scene());
      if (found.isEmpty()) {
        return;
      }
      SceneNames names = found.get();
      String file = String.valueOf(view.scene().getFileName());
      if (!view.viewpoint().isEmpty() && !names.viewpoints().contains(view.viewpoint())) {
        tell(
            source(view.viewpoint(), view.step()),
            "the scene %s and its Inlines have no Viewpoint with the DEF '%s', from which %s is seen%s"
                .formatted(
                    file,
                    view.viewpoint(),
                    view.step(),
                    meant(view.viewpoint(), names.viewpoints())));
      }
      view.choices()
          .forEach(
              (name, choice) -> {
                Integer choices = names.switches().get(name);
                if (choices == null) {
                  tell(
                      source(name, view.step()),
                      "the scene %s and its Inlines have no Switch with the DEF '%s', whose choice %s sets%s"
                          .formatted(
                              file, name, view.step(), meant(name, names.switches().keySet())));
                } else if (choice < -1 || choice >= choices) {
                  tell(
                      source(name, view.step()),
                      "the Switch %s of the scene %s has the choices 0 to %d, and -1 for none, but %s sets %d"
                          .formatted(name, file, choices - 1, view.step(), choice));
                }
              });
    }

    private static String meant(String name, Set<String> known) {
      return SpellingSuggester.nearest(name, known)
          .map(near -> "; did you mean '" + near + "'?")
          .orElse("");
    }

    /** Checks that the objects of memory lists are in the scene or not, as the lists say. */
    void items() throws IOException {
      for (var source : study.questionnaires().list()) {
        if (source.content() instanceof Content.Items items
            && items.kind() == ItemQuestionnaireKind.RECOGNITION
            && study.scene().isPresent()) {
          Optional<SceneNames> names = scene(study.scene().get());
          Optional<CsvTable> table =
              CsvTable.parse(
                  items.file().toString(), CsvTable.bytes(items.file()), (at, fault) -> {});
          if (names.isPresent() && table.isPresent() && table.get().has(SCENE_OBJECT)) {
            table.get().rows().forEach(row -> item(row, names.get()));
          }
        }
      }
    }

    private void item(CsvRow row, SceneNames names) {
      String object = row.cell(SCENE_OBJECT);
      boolean present = row.cell("present").equalsIgnoreCase("yes");
      if (present && object.isEmpty()) {
        tell(
            row.location(SCENE_OBJECT),
            "%s is present, so %s must be the DEF of the object in the scene"
                .formatted(row.cell("object"), SCENE_OBJECT));
      } else if (present && !names.all().contains(object)) {
        tell(
            row.location(SCENE_OBJECT),
            "%s is listed as present, but the scene and its Inlines have no node with the DEF '%s'%s"
                .formatted(row.cell("object"), object, meant(object, names.all())));
      } else if (!present && !object.isEmpty() && names.all().contains(object)) {
        tell(
            row.location(SCENE_OBJECT),
            "%s is listed as absent, but the scene has the object %s"
                .formatted(row.cell("object"), object));
      }
    }

    /** Loads scenes as sessions do, and returns the polygons of the views. */
    Map<String, Long> load(List<StudyView> views) {
      Map<String, Long> polygons = new LinkedHashMap<>();
      Set<Problem> known = new HashSet<>(); // Views of one scene share most.
      for (StudyView view : views.subList(0, Math.min(MOST_VIEWS, views.size()))) {
        List<Problem> own = new ArrayList<>();
        try (Walkthrough walk = SceneViewer.open(view, study.seed(), study.access(), own::add)) {
          polygons.put(view.title(), walk.polygons());
          own.stream().filter(known::add).forEach(problems::add);
        } catch (IOException e) {
          tell(
              at(String.valueOf(view.scene().getFileName())),
              "the scene cannot be shown (%s)".formatted(e.getMessage()));
        }
      }
      return polygons;
    }
  }
}
