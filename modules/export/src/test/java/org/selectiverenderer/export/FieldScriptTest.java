package org.selectiverenderer.export;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.joml.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.selectiverenderer.authoring.packaging.PackagedFile;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.World;
import org.selectiverenderer.browser.loading.SceneLoader;
import org.selectiverenderer.browser.nodes.NodeFactory;
import org.selectiverenderer.browser.sai.EmbeddedBrowser;
import org.selectiverenderer.control.SelectiveController;
import org.selectiverenderer.schema.Condition;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.ReadLimits;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HttpFetcher;
import org.selectiverenderer.x3d.write.SceneFormat;
import org.web3d.x3d.sai.MFDouble;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.SFBool;
import org.web3d.x3d.sai.SFColor;
import org.web3d.x3d.sai.SFFloat;
import org.web3d.x3d.sai.SFInt32;
import org.web3d.x3d.sai.X3DExecutionContext;
import org.web3d.x3d.sai.X3DField;
import org.web3d.x3d.sai.X3DScene;

/** The exported Script sets the fields that the controller of this program sets. */
class FieldScriptTest {
  /** Into the desk, into the kitchen around both, out of the desk, out of all, and so on. */
  private static final List<Double> WALK =
      List.of(-9.0, -7.0, -3.0, 0.0, 3.0, 0.0, 7.0, 9.0, 7.0, 0.0, -7.0, 3.0);

  private static final List<String> FIELDS =
      List.of(
          "Switch_Cup.whichChoice",
          "Switch_Sun.whichChoice",
          "Paint.url",
          "Lamp.on",
          "Lamp.intensity",
          "Gloss.shininess",
          "Gloss.emissiveColor",
          "Shading.value",
          "Rate.value",
          "Shadow.whichChoice");

  private static final Map<SceneFormat, String> ENDINGS =
      Map.of(SceneFormat.XML, ".x3d", SceneFormat.CLASSIC, ".x3dv", SceneFormat.JSON, ".x3dj");

  @TempDir Path folder;
  private final ProblemCollector problems = new ProblemCollector();

  @BeforeEach
  void pictures() throws IOException {
    Files.createDirectories(folder.resolve("pictures"));
    Files.createDirectories(folder.resolve("house"));
    for (String name : List.of("wood.png", "wood_50.png", "wood_25.png")) {
      BufferedImage image = new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB);
      ImageIO.write(image, "png", folder.resolve("pictures/" + name).toFile());
    }
  }

  private static String string(String name, String value) {
    return "<MetadataString name='%s' value='%s'/>".formatted(name, value);
  }

  private static String level(String degree, String schema, String value) {
    return "<MetadataSet>"
        + string("degreeOfConsistency", "\"" + degree + "\"")
        + (schema.isEmpty() ? "" : string("schemaBelonginess", "\"" + schema + "\""))
        + (value == null ? "" : string("value", value))
        + "</MetadataSet>";
  }

  private static String quality(String quality, String field, String... levels) {
    return "<MetadataSet>"
        + string("quality", "\"" + quality + "\"")
        + string("field", "\"" + field + "\"")
        + String.join("", levels)
        + "</MetadataSet>";
  }

  private static String object(String def, String versions, String... qualities) {
    return "<Switch DEF='%s' whichChoice='0'><Group/><Group/>".formatted(def)
        + "<MetadataSet containerField='metadata'>"
        + "<MetadataSet containerField='metadata' name='fieldQualities'>"
        + String.join("", qualities)
        + "</MetadataSet>"
        + versions
        + "</MetadataSet></Switch>";
  }

  private static String area(String def, double x, double size, String enter, String exit) {
    return "<Transform translation='%s 0 0'><ProximitySensor DEF='%s' size='%s 4 4'>"
            .formatted(x, def, size)
        + "<MetadataSet containerField='metadata'>"
        + string("enterTimeSchema", "\"" + enter + "\"")
        + string("exitTimeSchema", "\"" + exit + "\"")
        + "</MetadataSet></ProximitySensor></Transform>";
  }

  /** A desk inside a kitchen, and objects with fields of all kinds. */
  private static String scene() {
    String versions = level("low", "desk", null) + level("high", "kitchen", null);
    return "<X3D profile='Full' version='4.0'><head/><Scene>\n"
        + area("KitchenProx", 0, 12, "kitchen", "hall")
        + area("DeskProx", 0, 2, "desk", "kitchen")
        + object(
            "Switch_Cup",
            versions,
            quality(
                "textures",
                "Paint.url",
                level("low", "hall", "\"../pictures/wood.png\""),
                level("0.5", "kitchen", "\"../pictures/wood_50.png\" \"../pictures/wood.png\""),
                level("high", "desk", "\"../pictures/wood_25.png\"")),
            quality("shading", "Shading.value", level("low", "", "\"pixel\""),
                level("high", "", "\"flat\" \"vertex\"")),
            quality("light", "Lamp.intensity", level("low", "hall", "\"0.75\""),
                level("high", "kitchen", "\"0.25\"")))
        + object("Switch_Sun", string("quality", "\"light\"") + versions)
        + object(
            "Switch_Plain",
            "",
            quality("light", "Lamp.on", level("low", "kitchen", "\"true\""),
                level("high", "desk", "\"false\"")),
            quality("shading", "Gloss.shininess", level("low", "desk", "\"0.5\""),
                level("high", "kitchen", "\"0.125\"")),
            quality("light", "Gloss.emissiveColor", level("low", "hall", "\"0 0 0\""),
                level("high", "kitchen", "\"0.5 0.25\" \"1\"")),
            quality("animation", "Rate.value", level("low", "hall", "\"60\""),
                level("high", "desk", "\"4 5\"")),
            quality("light", "Shadow.whichChoice", level("low", "hall", "\"0\""),
                level("high", "desk", "\"-1\"")))
        + "<Shape><Appearance>"
        + "<MetadataString DEF='Shading' containerField='metadata' value='\"pixel\"'/>"
        + "<Material DEF='Gloss' shininess='0.2'/>"
        + "<ImageTexture DEF='Paint' url='\"../pictures/wood.png\"'/></Appearance><Box/></Shape>"
        + "<DirectionalLight DEF='Lamp'/><Switch DEF='Shadow' whichChoice='0'><Group/></Switch>"
        + "<TimeSensor><MetadataDouble DEF='Rate' containerField='metadata' value='60'/>"
        + "</TimeSensor>\n</Scene></X3D>";
  }

  private Path write(String text) throws IOException {
    return Files.writeString(folder.resolve("house/house.x3d"), text);
  }

  private Optional<ExportedScene> export(
      String text, SceneFormat format, Condition condition, boolean script) throws IOException {
    return new SceneExporter(
            NodeCatalogue.load(),
            new ContentAccessPolicy(List.of(folder), HttpFetcher.none()),
            problems)
        .export(
            write(text),
            new ExportSettings(condition, 7, format, UnaryOperator.identity(), script),
            "house" + ENDINGS.get(format));
  }

  private Path exported(String text, SceneFormat format, Condition condition) throws IOException {
    ExportedScene exported = export(text, format, condition, true).orElseThrow();
    assertThat(problems.list()).isEmpty();
    Path copy = Files.createDirectories(folder.resolve("copy"));
    List<PackagedFile> files = new ArrayList<>(exported.files().files());
    files.add(exported.files().scene());
    for (PackagedFile file : files) {
      Path target = copy.resolve(file.target());
      Files.createDirectories(target.getParent());
      Files.write(
          target,
          file.changed().isPresent() ? file.changed().get() : Files.readAllBytes(file.source()));
    }
    return copy.resolve(exported.files().scene().target());
  }

  /** Returns the values of the fields at each place of the walk. */
  private List<List<String>> walk(Path file, Condition controlled, List<String> fields)
      throws IOException {
    ProblemCollector found = new ProblemCollector();
    try (SceneLoader loader =
        new SceneLoader(
            NodeCatalogue.load(),
            new NodeFactory(),
            ReadLimits.standard(),
            new ContentAccessPolicy(List.of(folder), HttpFetcher.none()),
            found)) {
      World world = new World(loader.load(file), found);
      EmbeddedBrowser browser = new EmbeddedBrowser(world, loader, line -> {}, Map.of());
      SelectiveController controller =
          controlled == null
              ? null
              : new SelectiveController(
                  browser,
                  new SelectiveController.Settings(controlled, 7),
                  event -> {},
                  problem -> {});
      world.instances().update();
      List<List<String>> values = new ArrayList<>();
      double time = 0;
      for (double x : WALK) {
        world.step(++time, (viewer, now, dt) -> viewer.moveTo(new Vector3d(x, 0, 0)));
        values.add(
            fields.stream().map(field -> value(browser.getExecutionContext(), field)).toList());
      }
      if (controller != null) {
        controller.close();
      }
      browser.dispose();
      assertThat(found.list()).as("problems").isEmpty();
      return values;
    }
  }

  private static String value(X3DExecutionContext scene, String name) {
    int dot = name.indexOf('.');
    X3DField field =
        ((X3DScene) scene).getNamedNode(name.substring(0, dot)).getField(name.substring(dot + 1));
    String value = "";
    if (field instanceof SFBool truth) {
      value = "" + truth.getValue();
    } else if (field instanceof SFInt32 number) {
      value = "" + number.getValue();
    } else if (field instanceof SFFloat number) {
      value = "" + number.getValue();
    } else if (field instanceof SFColor colour) {
      float[] parts = new float[3];
      colour.getValue(parts);
      value = Arrays.toString(parts);
    } else if (field instanceof MFString strings) {
      String[] parts = new String[strings.getSize()];
      strings.getValue(parts);
      value = Stream.of(parts).map(part -> part.replaceAll(".*/", "")).toList().toString();
    } else if (field instanceof MFDouble numbers) {
      double[] parts = new double[numbers.getSize()];
      numbers.getValue(parts);
      value = Arrays.toString(parts);
    }
    return name + " " + value;
  }

  @ParameterizedTest
  @EnumSource(Condition.class)
  void theScriptSetsWhatTheControllerSets(Condition condition) throws IOException {
    List<List<String>> wanted = walk(write(scene()), condition, FIELDS);

    assertThat(walk(exported(scene(), SceneFormat.XML, condition), null, FIELDS)).isEqualTo(wanted);

    long values = wanted.stream().flatMap(List::stream).distinct().count();
    assertThat(values)
        .as("values that were seen")
        .isGreaterThanOrEqualTo(condition.switches() ? 20 : 10);
  }

  @ParameterizedTest
  @EnumSource(SceneFormat.class)
  void everyEncodingHoldsTheValues(SceneFormat format) throws IOException {
    List<List<String>> wanted = walk(write(scene()), Condition.SELECTIVE, FIELDS);

    assertThat(walk(exported(scene(), format, Condition.SELECTIVE), null, FIELDS))
        .isEqualTo(wanted);
  }

  @Test
  void picturesOfAllLevelsAreInTheCopyAndNamedFromThere() throws IOException {
    Path copy = exported(scene(), SceneFormat.XML, Condition.SELECTIVE);

    String text = Files.readString(copy);
    assertThat(text).doesNotContain("../pictures");
    for (String name : List.of("wood.png", "wood_50.png", "wood_25.png")) {
      assertThat(Files.walk(copy.getParent())).anyMatch(file -> file.endsWith(name));
    }
    String script = text.substring(text.indexOf("<![CDATA["), text.indexOf("]]>"));
    assertThat(script).doesNotContain("\"", "\\");
  }

  @Test
  void fieldsOfInlinedRoomsAreSetInEachOfThem() throws IOException {
    String lamp =
        object(
                "Switch_Lamp",
                "",
                quality("light", "Lamp.on", level("low", "hall", "\"true\""),
                    level("high", "desk", "\"false\"")))
            + "<DirectionalLight DEF='Lamp'/>";
    Files.writeString(
        folder.resolve("house/room.x3d"),
        "<X3D profile='Full' version='4.0'><Scene>" + lamp + "</Scene></X3D>",
        StandardCharsets.UTF_8);
    String house =
        "<X3D profile='Full' version='4.0'><head/><Scene>"
            + area("DeskProx", 0, 2, "desk", "hall")
            + "<Inline url='\"room.x3d\"'/><Inline url='\"room.x3d\"'/></Scene></X3D>";

    List<List<String>> values =
        walk(exported(house, SceneFormat.XML, Condition.SELECTIVE), null,
            List.of("Lamp.on", "Lamp_2.on"));

    assertThat(values.get(2)).containsExactly("Lamp.on true", "Lamp_2.on true");
    assertThat(values.get(3)).containsExactly("Lamp.on false", "Lamp_2.on false");
    assertThat(values.get(4)).containsExactly("Lamp.on true", "Lamp_2.on true");
  }

  /** The light is off by something else than the Script when the viewer comes in. */
  @Test
  void aRouteThatSetsAFieldIsNoticed() throws IOException {
    String clicks =
        "<ProximitySensor DEF='Wide' size='16 16 16'/><BooleanFilter DEF='Off'/>"
            + "<ROUTE fromNode='Wide' fromField='isActive' toNode='Off' toField='set_boolean'/>"
            + "<ROUTE fromNode='Off' fromField='inputNegate' toNode='Lamp' toField='set_on'/>"
            + "</Scene>";
    String text = scene().replace("</Scene>", clicks);

    assertThat(
            walk(exported(text, SceneFormat.XML, Condition.SELECTIVE), null, List.of("Lamp.on")))
        .isEqualTo(walk(write(text), Condition.SELECTIVE, List.of("Lamp.on")));
  }

  @ParameterizedTest
  @CsvSource({
    "Paint.url,Nobody.url,Nobody.url keeps its value in the export: the file itself has no node",
    "Lamp.on,Lamp.off,Lamp.off keeps its value in the export: Lamp has no such field",
  })
  void aFieldThatCannotBeSetIsSaidWithItsPlace(String field, String wrong, String message)
      throws IOException {
    String text = scene().replace("\"" + field + "\"", "\"" + wrong + "\"");

    assertThat(export(text, SceneFormat.XML, Condition.SELECTIVE, true)).isPresent();

    assertThat(problems.list())
        .singleElement()
        .satisfies(
            problem -> {
              assertThat(problem.severity()).isEqualTo(Problem.Severity.WARNING);
              assertThat(problem.message()).startsWith(message);
              assertThat(problem.location().line()).isPositive();
            });
  }

  @Test
  void withoutTheScriptFieldsStayAndThatIsSaid() throws IOException {
    String text = scene().replace(area("DeskProx", 0, 2, "desk", "kitchen"), "");
    assertThat(export(text, SceneFormat.XML, Condition.SELECTIVE, false)).isPresent();
    assertThat(problems.list())
        .extracting(Problem::message)
        .contains(
            "Paint.url keeps its value, since only the Script sets fields;"
                + " export without --without-script");
  }
}
