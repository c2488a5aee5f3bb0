package org.selectiverenderer.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.authoring.Edit;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.area.AreaLocator;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.sai.EmbeddedBrowser;
import org.selectiverenderer.browser.viewer.CameraPath;
import org.selectiverenderer.browser.viewer.CameraPathReader;
import org.selectiverenderer.browser.viewer.PathMotion;
import org.selectiverenderer.control.ControlEvent;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.web3d.x3d.sai.grouping.Switch;

/** The exported Script does what the controller of this program does. */
class ControllerScriptTest {
  private static final double RATE = 4;
  private static final String TOUR = "apartment-tour.csv";

  @TempDir Path folder;

  /** A change of a Switch that a viewer could see. */
  private record Change(int frame, String object, int choice) {}

  /** Neither the objects' files nor pictures are needed to see which is to be shown when. */
  private static String apartment() throws IOException {
    return bare(Files.readString(Path.of("scenes/apartment.x3d")));
  }

  private static String bare(String scene) {
    return scene
        .replaceAll("<Inline (DEF='\\w+' )?(url|USE)='[^']*'/>", "<Group/>")
        .replaceAll("\\w+Url='[^']*'", "");
  }

  private static ControlledNodes nodes(SceneDocument document) {
    NodeCatalogue catalogue = NodeCatalogue.load();
    return ControlledNodes.of(
        new DocumentEnrichment(document, catalogue), catalogue, new ProblemCollector());
  }

  private static SceneDocument exported(String scene, Condition condition, int seed)
      throws IOException {
    SceneDocument document = SceneDocument.of("scene.x3d", scene.getBytes(StandardCharsets.UTF_8));
    ControlledNodes nodes =
        nodes(document);
    List<String> lines = new ControllerScript(nodes, "SchemaController").lines(condition, seed);
    var root = document.tree().orElseThrow().scene().orElseThrow();
    document.perform(new Edit("export", List.of(document.layout().insertLast(root, lines))));
    return document;
  }

  private List<Change> walk(
      String scene, String way, boolean controlled, Condition condition, long seed)
      throws IOException {
    return walk(scene, way, controlled, condition, seed, event -> {});
  }

  private List<Change> walk(
      String scene,
      String way,
      boolean controlled,
      Condition condition,
      long seed,
      Consumer<ControlEvent> events)
      throws IOException {
    CameraPath path =
        CameraPathReader.read(Path.of("scenes/paths").resolve(way), new ProblemCollector())
            .orElseThrow();
    ProblemCollector problems = new ProblemCollector();
    Path file = Files.writeString(folder.resolve("scene.x3d"), scene);
    try (SceneLoader loader =
        new SceneLoader(
            NodeCatalogue.load(),
            new NodeFactory(),
            ReadLimits.standard(),
            ContentAccessPolicy.none(),
            problems)) {
      World world = new World(loader.load(file), problems);
      EmbeddedBrowser browser = new EmbeddedBrowser(world, loader, line -> {}, Map.of());
      SelectiveController.Settings settings = new SelectiveController.Settings(condition, seed);
      SelectiveController controller =
          controlled ? new SelectiveController(browser, settings, events, problem -> {}) : null;
      world.instances().update();
      List<Change> changes = new ArrayList<>();
      Map<String, Integer> shown = new HashMap<>();
      PathMotion motion = new PathMotion(path, 0);
      for (int frame = 0; frame / RATE < path.end(); frame++) {
        world.step(frame / RATE, motion);
        for (String object : objects(scene)) {
          int choice =
              ((Switch) browser.getExecutionContext().getNamedNode(object)).getWhichChoice();
          Integer before = shown.put(object, choice);
          if (before == null || before != choice) {
            changes.add(new Change(frame, object, choice));
          }
        }
      }
      if (controller != null) {
        controller.close();
      }
      browser.dispose();
      assertThat(problems.list()).as("problems").isEmpty();
      return changes;
    }
  }

  /** Returns the names of the objects that can be asked for: those in no prototype. */
  private static List<String> objects(String scene) throws IOException {
    if (scene.contains("<ProtoDeclare")) {
      return List.of();
    }
    SceneDocument document = SceneDocument.of("scene.x3d", scene.getBytes(StandardCharsets.UTF_8));
    return nodes(document)
        .objects()
        .stream()
        .map(ControlledNodes.VersionedObject::def)
        .toList();
  }

  @ParameterizedTest
  @EnumSource(Condition.class)
  void theScriptSwitchesWhenAndWhatTheControllerSwitches(Condition condition) throws IOException {
    String exported = exported(apartment(), condition, 7).text().toString();

    assertThat(walk(exported, TOUR, false, condition, 7))
        .hasSizeGreaterThan(30)
        .isEqualTo(walk(apartment(), TOUR, true, condition, 7));
  }

  @ParameterizedTest
  @CsvSource({"trashcan.x3d, desk-visit.csv, 3", "overlap.x3d, overlap-visit.csv, 16"})
  void theScriptSwitchesWhatTheControllerSwitchesWhereAreasOverlap(
      String scene, String way, int changes) throws IOException {
    String bare = bare(Files.readString(Path.of("scenes").resolve(scene)));
    String exported = exported(bare, Condition.SELECTIVE, 0).text().toString();

    assertThat(walk(exported, way, false, Condition.SELECTIVE, 0))
        .hasSizeGreaterThanOrEqualTo(changes)
        .isEqualTo(walk(bare, way, true, Condition.SELECTIVE, 0));
  }

  /** Xj3D puts the text of a Script between quotation marks and reads it as a url then. */
  @Test
  void theTextOfTheScriptHasNoQuotationMarks() throws IOException {
    String scene = exported(apartment(), Condition.SELECTIVE, 0).text().toString();
    int start = scene.indexOf("<![CDATA[ecmascript:");
    assertThat(scene.substring(start, scene.indexOf("]]>", start)))
        .hasSizeGreaterThan(1000)
        .doesNotContain("\"", "\\");
  }

  @Test
  void filtersAndTriggersSwitchWhenAndWhatTheControllerSwitchesWhereNoAreasOverlap()
      throws IOException {
    String scene = Files.readString(Path.of("scenes/trashcan.x3d"));
    scene = bare(scene);
    SceneDocument document = SceneDocument.of("scene.x3d", scene.getBytes(StandardCharsets.UTF_8));
    ControlledNodes nodes =
        nodes(document);
    List<String> lines = new ControllerRoutes(nodes, name -> name).lines();
    var root = document.tree().orElseThrow().scene().orElseThrow();
    document.perform(new Edit("export", List.of(document.layout().insertLast(root, lines))));

    String path = "desk-visit.csv";
    assertThat(walk(document.text().toString(), path, false, Condition.SELECTIVE, 0))
        .hasSizeGreaterThan(2)
        .isEqualTo(walk(scene, path, true, Condition.SELECTIVE, 0));
  }

  /**
   * The objects of prototypes have no names in the scene: their changes are those that are told.
   */
  @Test
  void objectsOfPrototypeInstancesSwitchWhenTheControllerSwitchesThem() throws IOException {
    String scene = bare(Files.readString(Path.of("scenes/trashcan.x3d")));
    int start = scene.indexOf("<Switch ");
    int end = scene.indexOf("</Switch>") + "</Switch>".length();
    String object =
        scene
            .substring(start, end)
            .replace(
                "whichChoice='1'>",
                "><IS><connect nodeField='whichChoice' protoField='first'/></IS>");
    String declarations =
        "<ProtoDeclare name='Bin'><ProtoInterface>"
            + "<field name='first' type='SFInt32' accessType='inputOutput' value='1'/>"
            + "<field name='parts' type='MFNode' accessType='inputOutput'><Group DEF='None'/></field>"
            + "</ProtoInterface><ProtoBody><Transform><IS>"
            + "<connect nodeField='children' protoField='parts'/></IS>"
            + object
            + "</Transform></ProtoBody></ProtoDeclare>"
            + "<ProtoDeclare name='Bins'><ProtoInterface>"
            + "<field name='begins' type='SFInt32' accessType='initializeOnly' value='0'/>"
            + "</ProtoInterface><ProtoBody><Group><ProtoInstance name='Bin'><IS>"
            + "<connect nodeField='first' protoField='begins'/></IS></ProtoInstance></Group>"
            + "</ProtoBody></ProtoDeclare>";
    String instances =
        "<ProtoInstance name='Bin' DEF='One'><fieldValue name='parts'><Shape/></fieldValue>"
            + "</ProtoInstance><ProtoInstance name='Bins'/><ProtoInstance USE='One'/>";
    String prototypes =
        (scene.substring(0, start) + instances + scene.substring(end))
            .replace("<Scene>", "<Scene>" + declarations);
    SceneDocument document =
        SceneDocument.of("scene.x3d", prototypes.getBytes(StandardCharsets.UTF_8));
    ProblemCollector problems = new ProblemCollector();

    assertThat(new PrototypeFlattener(NodeCatalogue.load(), problems).flatten(document)).isTrue();

    assertThat(problems.list()).isEmpty();
    String flat = document.text().toString();
    assertThat(flat)
        .doesNotContain("Proto", "IS>")
        .contains("<Group DEF='One'>", "<Group USE='One'/>", "<Shape/>");
    assertThat(objects(flat)).hasSize(2);
    List<String> told = new ArrayList<>();
    walk(
        prototypes,
        "desk-visit.csv",
        true,
        Condition.SELECTIVE,
        0,
        event -> {
          if (event instanceof ControlEvent.SwitchChange change) {
            long frame = Math.round(change.time() * RATE) % 1024; // the clock begins at 2 to the 30
            told.add(frame + " " + change.to());
          }
        });
    List<Change> shown =
        walk(
            exported(flat, Condition.SELECTIVE, 0).text().toString(),
            "desk-visit.csv",
            false,
            Condition.SELECTIVE,
            0);
    assertThat(told).hasSize(3); // one begins as the desk wants it
    assertThat(shown.subList(2, shown.size()).stream().map(c -> c.frame() + " " + c.choice()))
        .containsExactlyInAnyOrderElementsOf(told);
  }

  @Test
  void areasThatOverlapAndDecideOnTheSameObjectNeedTheScript() throws IOException {
    String scene =
        Files.readString(Path.of("scenes/overlap.x3d")); // the areas of Table 5, which overlap
    SceneDocument document =
        SceneDocument.of("overlap.x3d", bare(scene).getBytes(StandardCharsets.UTF_8));
    DocumentEnrichment enrichment = new DocumentEnrichment(document, NodeCatalogue.load());
    ProblemCollector problems = new ProblemCollector();

    assertThat(
            new ControllerRoutes(ControlledNodes.of(enrichment, NodeCatalogue.load(), problems), name -> name)
                .decided(AreaLocator.of(enrichment), problems))
        .isFalse();
    assertThat(problems.list())
        .first()
        .satisfies(
            problem -> {
              assertThat(problem.message()).contains("overlap, and both decide on");
              assertThat(problem.location().line()).isPositive();
            });
  }

  @Test
  void aRouteOfTheSceneThatSetsAChoiceIsNoticed() throws IOException {
    String clicks =
        "<TouchSensor DEF='Click'/><IntegerTrigger DEF='One' integerKey='0'/>"
            + "<ROUTE fromNode='One' fromField='triggerValue' toNode='Switch_TrashCan'"
            + " toField='set_whichChoice'/></Scene>";
    String scene =
        bare(Files.readString(Path.of("scenes/trashcan.x3d"))).replace("</Scene>", clicks);

    assertThat(exported(scene, Condition.SELECTIVE, 0).text().toString())
        .contains("function changed0(choice) { now[0] = choice; }")
        .contains(
            "<ROUTE fromField=\"whichChoice\" fromNode=\"Switch_TrashCan\" toField=\"changed0\"");
  }

  @Test
  void theRulesStayShortEnoughToRead() throws IOException {
    String text = exported(apartment(), Condition.SELECTIVE, 0).text().toString();
    String rules = text.substring(text.indexOf("<![CDATA["), text.indexOf("// Below stands"));

    assertThat(rules.lines().count()).isLessThan(300);
  }
}
