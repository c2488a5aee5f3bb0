package org.selectiverenderer.export;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.authoring.packaging.PackageLayout;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.authoring.packaging.ScenePackage;
import org.selectiverenderer.authoring.packaging.ScenePackager;
import org.selectiverenderer.authoring.structure.NeededComponents;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementScope;
import org.selectiverenderer.x3d.source.TextEdit;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * Exports an enriched scene with all its files, so that browsers render it selectively that know
 * nothing of this program: a Script of the scene sets the choices of its Switches.
 */
public final class SceneExporter {
  static final String NOTHING_TO_CONTROL =
      "the scene has no enriched object, so that there is nothing to control; enrich it first";

  private static final String SCRIPT = "SchemaController";

  private final NodeCatalogue catalogue;
  private final ContentAccessPolicy access;
  private final ProblemCollector problems;

  /**
   * Creates an exporter.
   *
   * @param access the files that scenes may read besides those of their own project
   * @param problems receives what cannot be exported, as errors, and what other browsers may lack
   */
  public SceneExporter(
      NodeCatalogue catalogue, ContentAccessPolicy access, ProblemCollector problems) {
    this.catalogue = catalogue;
    this.access = access;
    this.problems = problems;
  }

  /**
   * Exports a scene; nothing is written.
   *
   * @param name the file name of the exported scene
   * @return empty if it cannot be exported, which is reported as an error
   * @throws IOException if a file cannot be read, with a sentence
   */
  public Optional<ExportedScene> export(Path scene, ExportSettings settings, String name)
      throws IOException {
    return export(scene, settings, name, false);
  }

  /**
   * Exports a scene as {@link #export(Path, ExportSettings, String)}, also one without an enriched
   * object, which then has no controller.
   */
  public Optional<ExportedScene> exportAny(Path scene, ExportSettings settings, String name)
      throws IOException {
    return export(scene, settings, name, true);
  }

  private Optional<ExportedScene> export(
      Path scene, ExportSettings settings, String name, boolean any) throws IOException {
    Path folder = Objects.requireNonNull(scene.toRealPath().getParent());
    UrlResolver resolver = new UrlResolver(folder, access);
    Optional<SceneDocument> flat =
        new InlineFlattener(catalogue, resolver, problems).flatten(scene);
    if (flat.isEmpty()) {
      return Optional.empty();
    }
    SceneDocument document = flat.get();
    if (!new PrototypeFlattener(catalogue, problems).flatten(document)) {
      return Optional.empty();
    }
    DocumentEnrichment enrichment = new DocumentEnrichment(document, catalogue);
    Optional<String> script = Optional.empty();
    if (!any || enrichment.switches().stream().anyMatch(EnrichedSwitch::controlled)) {
      if (!exportable(document, enrichment, scene)) {
        return Optional.empty();
      }
      nameNodes(document, enrichment);
      ControlledNodes nodes = ControlledNodes.of(enrichment, catalogue, problems);
      if (settings.script()) {
        script = Optional.of(addScript(document, nodes, settings));
      } else if (!addRoutes(document, nodes, enrichment)) {
        return Optional.empty();
      }
    }
    PackageLayout layout = PackageLayout.around(folder, settings.names());
    ScenePackager packager = new ScenePackager(catalogue, folder, access, layout, () -> false);
    ScenePackage files = packager.collect(scene, document.snapshot(), Path.of(name));
    return Optional.of(
        new ExportedScene(
            settings.format() == SceneFormat.XML ? files : encoded(files, settings.format()),
            script,
            title(document).orElse(stem(scene))));
  }

  /** Returns the title that the first WorldInfo with one tells (X3D 4.0, 10.4.5). */
  private static Optional<String> title(SceneDocument document) {
    List<String> titles = new ArrayList<>();
    document
        .tree()
        .orElseThrow()
        .root()
        .visit(
            element -> {
              if (element.name().equals("WorldInfo")) {
                element.text("title").filter(text -> !text.isBlank()).ifPresent(titles::add);
              }
            });
    return titles.stream().findFirst();
  }

  /** Returns the name of a file without its ending. */
  private static String stem(Path file) {
    String name = String.valueOf(file.getFileName());
    int dot = name.indexOf('.', 1);
    return dot < 0 ? name : name.substring(0, dot);
  }

  private boolean exportable(SceneDocument document, DocumentEnrichment enrichment, Path scene) {
    List<DocumentElement> enriched = new ArrayList<>();
    enrichment.switches().stream()
        .filter(EnrichedSwitch::controlled)
        .map(EnrichedSwitch::element)
        .forEach(enriched::add);
    boolean objects = !enriched.isEmpty();
    enrichment.sensors().stream()
        .filter(EnrichedSensor::enriched)
        .map(EnrichedSensor::element)
        .forEach(enriched::add);
    if (!objects || document.tree().flatMap(tree -> tree.scene()).isEmpty()) {
      problems.error(SourceLocation.of(scene.toString()), NOTHING_TO_CONTROL);
      return false;
    }
    boolean all = true;
    for (DocumentElement element : enriched) {
      if (ElementScope.of(element).parent().isPresent()) {
        problems.error(
            element.location(),
            "%s is in the declaration of a prototype, whose nodes no ROUTE of the scene reaches;"
                    .formatted(element)
                + " put the object itself into the scene to export it");
        all = false;
      } else if (element.isReference()) {
        problems.error(
            element.location(),
            element + " comes from an entity of the DOCTYPE; write it out in the scene");
        all = false;
      }
    }
    return all;
  }

  /** Gives names to the enriched nodes that have none, for ROUTEs. */
  private static void nameNodes(SceneDocument document, DocumentEnrichment enrichment) {
    NodeNamer names = new NodeNamer(document);
    enrichment.sensors().stream()
        .filter(EnrichedSensor::enriched)
        .forEach(sensor -> names.name(sensor.element(), "Area"));
    enrichment.switches().stream()
        .filter(EnrichedSwitch::enriched)
        .forEach(node -> names.name(node.element(), "Switch"));
    List<TextEdit> edits = new ArrayList<>(names.edits());
    if (!edits.isEmpty()) {
      edits.sort(Comparator.comparingInt(TextEdit::from));
      document.perform(new Edit("Names", edits));
    }
  }

  /** Adds the Script, and returns its name. */
  private String addScript(SceneDocument document, ControlledNodes nodes, ExportSettings settings) {
    String def = new NodeNamer(document).unused(SCRIPT);
    add(
        document,
        Set.of("Script"),
        new ControllerScript(nodes, def).lines(settings.condition(), settings.seed()));
    return def;
  }

  /** Adds what controls the scene without a Script; returns whether that could be done. */
  private boolean addRoutes(
      SceneDocument document, ControlledNodes nodes, DocumentEnrichment enrichment) {
    if (!ControllerRoutes.carries(nodes, problems)) {
      return false;
    }
    NodeNamer names = new NodeNamer(document);
    ControllerRoutes routes = new ControllerRoutes(nodes, names::unused);
    if (!routes.decided(AreaLocator.of(enrichment), problems)) {
      return false;
    }
    add(document, ControllerRoutes.types(), routes.lines());
    return true;
  }

  /** Adds nodes at the end of the scene, and the components that they need. */
  private void add(SceneDocument document, Set<String> types, List<String> lines) {
    DocumentElement scene = document.tree().orElseThrow().scene().orElseThrow();
    List<TextEdit> edits = new ArrayList<>(new NeededComponents(document, catalogue).of(types));
    edits.add(document.layout().insertLast(scene, lines));
    edits.sort(Comparator.comparingInt(TextEdit::from));
    document.perform(new Edit("Controller", edits));
  }

  private ScenePackage encoded(ScenePackage files, SceneFormat format) throws IOException {
    byte[] xml = files.scene().changed().orElseThrow();
    XmlDocument document =
        new X3dReader(catalogue)
            .document(files.scene().source().toString(), new ByteArrayInputStream(xml), xml.length);
    byte[] bytes = format.text(document, catalogue, problems).getBytes(StandardCharsets.UTF_8);
    PackagedFile scene =
        new PackagedFile(files.scene().target(), files.scene().source(), Optional.of(bytes));
    return new ScenePackage(scene, files.files(), files.left(), List.of());
  }
}
