package org.selectiverenderer.export.study;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.authoring.packaging.ScenePackage;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.export.ExportSettings;
import org.selectiverenderer.export.ExportedScene;
import org.selectiverenderer.export.JatosArchive;
import org.selectiverenderer.export.SceneExporter;
import org.selectiverenderer.export.WebPage;
import org.selectiverenderer.export.WebScene;
import org.selectiverenderer.formats.json.JsonTree;
import org.selectiverenderer.formats.json.JsonWriter;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.study.definition.Study;
import org.selectiverenderer.study.session.LoadedStudy;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * A folder that any web server shows as a study: the page that runs it, {@code study-web.json}
 * which tells the page what to show to whom, {@code study-settings.json} with what the lab sets,
 * and the scenes.
 *
 * @param name the study's name, which researchers read
 * @param files all files of the folder
 */
public record StudyFolder(String name, List<PackagedFile> files) {
  /** Names of the two scenes of a study, and of their folders. */
  static final String SCENE = "scene";

  static final String PRACTICE = "practice";

  /** The name of the file in which the lab sets the receiver of the data and the like. */
  public static final String SETTINGS = "study-settings.json";

  private static final String DESCRIPTION = "study-web.json";

  private static final Path PAGE = Path.of("index.html");

  /** A host serves the page and takes the records. */
  public enum Host {
    /** Any web server; the lab names a receiver. */
    WEB_SERVER(""),
    /** JATOS, by its script jatos.js. */
    JATOS("jatos");

    private final String receiver;

    Host(String receiver) {
      this.receiver = receiver;
    }
  }

  public StudyFolder {
    files = List.copyOf(files);
  }

  /**
   * Puts the page around a study; nothing is written.
   *
   * @param page the page of {@link WebPage#ofStudy}
   * @param host who serves the folder
   * @param languages the study in each of its languages
   * @param problems receives what cannot be exported, as errors with lines, and placeholders of the
   *     template, as warnings
   * @return empty if the study cannot be exported, which is then reported
   * @throws IOException if a file cannot be read, with a sentence
   */
  public static Optional<StudyFolder> of(
      WebPage page, Host host, List<LoadedStudy> languages, ProblemCollector problems)
      throws IOException {
    LoadedStudy first = languages.get(0);
    Study study = first.study();
    ProblemCollector faults = new ProblemCollector(problems::add);
    boolean runs = true;
    for (LoadedStudy each : languages) {
      runs &= new BrowserLimits(each, faults).keep();
      if (!runs) {
        return Optional.empty(); // The other languages have the same faults.
      }
    }
    Map<String, WebScene> scenes = new LinkedHashMap<>();
    SceneSource source = new SceneSource(study, faults);
    Map<Path, String> ofTrials = new LinkedHashMap<>();
    if (study.design().blocks().isEmpty()) {
      if (study.scene().isPresent() && !study.areas().isEmpty()) {
        Set<String> viewpoints = new TreeSet<>();
        study.areas().forEach(area -> viewpoints.add(area.viewpoint()));
        TrialScenes.Needs needs = new TrialScenes.Needs(viewpoints, Set.of());
        source.put(SCENE, study.scene().get(), false, needs, scenes);
      }
    } else {
      try {
        for (Map.Entry<Path, TrialScenes.Needs> one : new TrialScenes(first).needs().entrySet()) {
          String scene = ofTrials.isEmpty() ? SCENE : SCENE + (ofTrials.size() + 1);
          ofTrials.put(one.getKey(), scene);
          source.put(scene, one.getKey(), true, one.getValue(), scenes);
        }
      } catch (IllegalArgumentException e) {
        faults.error(SourceLocation.of(study.file().toString()), e.getMessage());
      }
    }
    if (study.practice().isPresent()) {
      Study.Practice practice = study.practice().get();
      Set<String> viewpoints =
          practice.viewpoint().isEmpty() ? Set.of() : Set.of(practice.viewpoint());
      TrialScenes.Needs needs = new TrialScenes.Needs(viewpoints, Set.of());
      source.put(PRACTICE, practice.scene(), true, needs, scenes);
    }
    if (faults.anyError()) {
      return Optional.empty();
    }
    PlaceholderCheck.warn(study, faults);
    StudyPictures pictures = new StudyPictures();
    String description = new StudyDescription(languages, pictures).text(scenes, ofTrials);
    List<PackagedFile> files = new ArrayList<>(page.files());
    files.add(text(DESCRIPTION, description));
    files.add(text(SETTINGS, settings(host, study)));
    scenes.values().forEach(scene -> files.addAll(scene.files()));
    files.addAll(pictures.files());
    return Optional.of(new StudyFolder(study.name(), files));
  }

  /**
   * Returns the files of a study archive of JATOS, one of whose folders is this one.
   *
   * @throws IOException if a file cannot be read, with a sentence
   */
  public List<PackagedFile> jatosArchive() throws IOException {
    return JatosArchive.files(name, PAGE, files);
  }

  /** Returns what a lab may set; the page works with it as it is. */
  private static String settings(Host host, Study study) {
    var json = JsonTree.object();
    json.put("receiver", host.receiver);
    json.put("completion", "");
    json.put("fullScreen", true);
    json.put("minWidth", 800);
    json.put("minHeight", 500);
    json.put("minRefresh", 0);
    json.put("minFrameRate", study.quality().minFps().orElse(0));
    json.put("headset", "no");
    return JsonWriter.of(json);
  }

  private static PackagedFile text(String name, String text) {
    return new PackagedFile(
        Path.of(name), Path.of(name), Optional.of(text.getBytes(StandardCharsets.UTF_8)));
  }

  /** Exports the scenes of a study. */
  private record SceneSource(Study study, ProblemCollector faults) {

    /**
     * Puts a scene.
     *
     * @param any whether it may be one without enriched objects
     */
    void put(
        String name, Path scene, boolean any, TrialScenes.Needs needs, Map<String, WebScene> scenes)
        throws IOException {
      NodeCatalogue catalogue = NodeCatalogue.load();
      SceneExporter exporter = new SceneExporter(catalogue, study.access(), faults);
      // The seed of the condition random is set by the page, for each participant.
      ExportSettings how =
          new ExportSettings(Condition.SELECTIVE, 0, SceneFormat.XML, WebScene::name, true);
      String file = WebScene.name(name + ".x3d"); // the file's own name may tell too much
      Optional<ExportedScene> exported =
          any ? exporter.exportAny(scene, how, file) : exporter.export(scene, how, file);
      if (exported.isEmpty()) {
        return;
      }
      for (ScenePackage.LeftOut left : exported.get().files().left()) {
        faults.error(
            SourceLocation.of(left.file()),
            "url '%s' %s; the study would lack it".formatted(left.url(), left.reason()));
      }
      requireNodes(catalogue, scene, exported.get(), needs);
      scenes.put(name, WebScene.of(exported.get(), Path.of(name)));
    }

    /**
     * Reports viewpoints that stand below other nodes, where the page cannot tell their place, and
     * Switches that are not there.
     */
    private void requireNodes(
        NodeCatalogue catalogue, Path scene, ExportedScene exported, TrialScenes.Needs needs)
        throws IOException {
      byte[] text = exported.files().scene().changed().orElseThrow();
      XmlDocument document =
          new X3dReader(catalogue)
              .document(scene.toString(), new ByteArrayInputStream(text), text.length);
      Set<String> free = new TreeSet<>();
      document.root().stream()
          .flatMap(root -> root.children().stream())
          .filter(element -> element.name().equals("Scene"))
          .flatMap(element -> element.children().stream())
          .filter(element -> element.name().equals("Viewpoint"))
          .flatMap(element -> element.def().stream())
          .forEach(free::add);
      for (String name : needs.viewpoints()) {
        if (!free.contains(name)) {
          faults.error(
              SourceLocation.of(scene.toString()),
              "the Viewpoint %s does not stand directly in the scene, as the page needs it"
                  .formatted(name));
        }
      }
      Set<String> switches = new TreeSet<>();
      document.elements().stream()
          .filter(element -> element.name().equals("Switch"))
          .forEach(element -> element.def().ifPresent(switches::add));
      for (String name : needs.switches()) {
        if (!switches.contains(name)) {
          faults.error(
              SourceLocation.of(scene.toString()),
              "the scene has no Switch with the DEF '%s', whose choice trials set".formatted(name));
        }
      }
    }
  }
}
