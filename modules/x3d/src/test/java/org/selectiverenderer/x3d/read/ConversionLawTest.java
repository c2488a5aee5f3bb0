package org.selectiverenderer.x3d.read;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.source.XmlDocument;
import org.selectiverenderer.x3d.write.SceneFormat;

/**
 * The law of conversion: what is written can be read; it is the same scene, or what differs is
 * told; and to convert it again changes and tells nothing.
 */
class ConversionLawTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();
  private static final X3dReader READER = new X3dReader(CATALOGUE);
  private static final SceneDigest DIGEST = new SceneDigest(CATALOGUE);
  private static final long LARGE = 70_000;

  static Stream<Path> scenes() throws IOException {
    return Stream.of(
            "scenes",
            "docs/examples",
            "inlineNodes",
            "modules/render/src/test/resources/conformance",
            "src/test/resources/hostile/scenes")
        .map(Path::of)
        .flatMap(ConversionLawTest::files);
  }

  private static Stream<Path> files(Path folder) {
    try (Stream<Path> files = Files.walk(folder)) {
      return files
          .filter(file -> file.toString().matches(".*\\.(x3d|x3dv|wrl|x3dj|json|xml|x3dz)"))
          .filter(file -> file.toFile().length() < LARGE)
          .filter(
              file -> !file.endsWith("quadratic-entities.x3d")) // stands for 16 million characters
          .filter(file -> !file.startsWith("inlineNodes") || file.hashCode() % 10 == 0) // alike
          .sorted()
          .toList()
          .stream();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns scenes as other programs write them, where they differ from what this one writes. */
  static Stream<String> scenesOfPrograms() {
    return Stream.of(
        // Python's ElementTree: a prefix for the namespace, line ends in references
        """
        <?xml version='1.0' encoding='UTF-8'?>
        <X3D xmlns:xsd="http://www.w3.org/2001/XMLSchema-instance" profile="Interchange"
        version="3.3" xsd:noNamespaceSchemaLocation="http://www.web3d.org/x3d-3.3.xsd"><Scene>
        <Shape><IndexedFaceSet coordIndex="0 1 2 -1&#10;2 1 0 -1"><Coordinate
        point="0 0 0&#10;1 0 0&#10;0 1 0" /></IndexedFaceSet></Shape></Scene></X3D>
        """,
        // Blender: commas in vectors and between strings, a blank in the last url
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.0//EN" "http://www.web3d.org/x3d-3.0.dtd">
        <X3D version="3.0" profile="Immersive"><head><meta name="filename" content="a b.x3d" />
        <meta name="generator" content="Blender 2.93.0" /></head><Scene>
        <NavigationInfo headlight="false" visibilityLimit="0.0" type='"EXAMINE", "ANY"'
        avatarSize="0.25, 1.75, 0.75" /><Transform DEF="Cube_TRANSFORM"
        translation="0.000000 0.000000 0.000000" rotation="0.000000 0.707107 0.707107 3.141593">
        <Group DEF="group_ME_Cube"><Shape><Appearance><ImageTexture DEF="IM_a"
        url='"textures/a.png" "a.png" "C:\\a.png" ' /><Material DEF="MA_a" diffuseColor="0.8 0.8 0.8"
        shininess="0.098" /></Appearance><IndexedFaceSet solid="true" coordIndex="0 1 2 3 -1 "
        texCoordIndex="0 1 2 3 -1 "><Coordinate DEF="coords_ME_Cube" point="1.0 1.0 -1.0 1.0 -1.0 -1.0
        -1.0 -1.0 -1.0 -1.0 1.0 -1.0 " /><TextureCoordinate point="0 0 1 0 1 1 0 1 " />
        </IndexedFaceSet></Shape></Group></Transform></Scene></X3D>
        """,
        // VTK: tabs, colours of vertices, backgrounds
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile=\"Immersive\" version=\"3.0\">\n"
            + "<head>\n<meta name=\"filename\" content=\"Stream\"/>\n</head>\n<Scene>\n<Background"
            + " skyColor=\"0.1 0.2 0.4\"/>\n<Shape>\n<Appearance>\n<Material"
            + " ambientIntensity=\"0\"/>\n</Appearance>\n<IndexedFaceSet solid=\"false\""
            + " colorPerVertex=\"true\" normalPerVertex=\"true\" coordIndex=\"\n0 1 2 -1\n\">\n"
            + "<Coordinate DEF=\"VTKcoordinates0000\" point=\"\t0 0 0,\n\t1 0 0,\n\t0 1 0,\n\"/>\n"
            + "<Color DEF=\"VTKcolors0000\" color=\"1 0 0,\n0 1 0,\n0 0 1,\n\"/>\n"
            + "</IndexedFaceSet>\n</Shape>\n</Scene>\n</X3D>\n",
        // VTK, in VRML97
        """
        #VRML V2.0 utf8
        # VRML file written by the visualization toolkit

        Background {
          skyColor [0.1 0.2 0.4]
        }
        Transform {
          translation 0 0 0
          children [
            Shape { appearance Appearance { material Material { ambientIntensity 0 } }
              geometry IndexedFaceSet { solid FALSE
                coord DEF VTKcoordinates Coordinate { point [
                  0 0 0,
                  1 0 0,
                  0 1 0,
                ] }
                coordIndex [ 0, 1, 2, -1, ] } } ] }
        """,
        // FreeCAD, CadQuery and MeshLab
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <X3D profile="Immersive" version="3.2"><Scene><Viewpoint id="Iso"
        centerOfRotation="0 0 0" position="1 1 1" orientation="0 0 1 0" description="camera"/>
        <Group onclick=""><Transform><Switch whichChoice='0' id='swBody'><Shape><Appearance>
        <Material id='color' diffuseColor='0.8 0.8 0.8' shininess='0.9' transparency='0.0'/>
        </Appearance><IndexedFaceSet coordIndex="0 1 2 -1 " solid="false"><Coordinate
        point="0.000000 0.000000 10.000000 1e-07 0 10 0 -1E-7 10 "/></IndexedFaceSet></Shape>
        </Switch></Transform></Group></Scene></X3D>
        """);
  }

  @ParameterizedTest
  @MethodSource
  void scenesOfPrograms(String scene) throws IOException {
    hold("a program's scene", scene.getBytes(StandardCharsets.UTF_8));
  }

  /** Damaged documents that still are whole enough to be converted. */
  @ParameterizedTest
  @EnumSource
  void damagedDocuments(SceneFormat format) throws IOException {
    Random random = new Random(7);
    for (int round = 0; round < 150; round++) {
      String scene = RandomScene.of(round, CATALOGUE);
      XmlDocument document = document(scene.getBytes(StandardCharsets.UTF_8));
      String text = format.text(document, CATALOGUE, new ProblemCollector());
      byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
      int at = 16 + random.nextInt(bytes.length - 40);
      switch (random.nextInt(3)) {
        case 0 -> bytes[at] = (byte) "{}[]#\"\\., :-@<>='&".charAt(random.nextInt(18));
        case 1 -> bytes[at] = (byte) ('A' + random.nextInt(58));
        default -> System.arraycopy(bytes, random.nextInt(bytes.length - 20), bytes, at, 10);
      }
      hold(format + " damaged, round " + round, bytes);
    }
  }

  private static XmlDocument document(byte[] bytes) throws IOException {
    return READER.document("scene", new ByteArrayInputStream(bytes), bytes.length);
  }

  /** Holds the law for a scene and all encodings that are written. */
  private static void hold(String name, byte[] scene) throws IOException {
    XmlDocument document = document(scene);
    if (document.broken()) {
      return; // is not converted
    }
    for (SceneFormat format : SceneFormat.values()) {
      hold(name + " as " + format, scene, document, format);
    }
  }

  private static void hold(String name, byte[] scene, XmlDocument document, SceneFormat format)
      throws IOException {
    ProblemCollector told = new ProblemCollector();
    String text = format.text(document, CATALOGUE, told);
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    XmlDocument written = document(bytes);
    assertThat(written.faults()).as(name).isEmpty();
    ProblemCollector again = new ProblemCollector();
    byte[] twice = format.text(written, CATALOGUE, again).getBytes(StandardCharsets.UTF_8);
    same(
        name + " again",
        DIGEST.document(document(twice)).stream(),
        DIGEST.document(written).stream());
    assertThat(messages(again))
        .as(name)
        .allMatch(message -> message.contains(" is used already at ")); // stays so
    if (told.any()) {
      return;
    }
    ProblemCollector first = new ProblemCollector();
    ProblemCollector second = new ProblemCollector();
    List<String> original = DIGEST.scene(READER.read("scene", scene, first));
    List<String> now = DIGEST.scene(READER.read("scene", bytes, second));
    same(name + " as a scene", now.stream(), original.stream());
    assertThat(messages(first)).as(name).containsAll(messages(second)); // encodings are mended
    if (messages(first).stream().anyMatch(message -> message.contains(" does not fit into "))) {
      return; // is written in the field where it was found to fit
    }
    same(
        name + " as a document",
        DIGEST.document(written).stream(),
        DIGEST.document(document).stream());
  }

  /** Compares lines, and shows only the first difference and what is around it. */
  private static void same(String name, Stream<String> now, Stream<String> original) {
    List<String> left = now.toList();
    List<String> right = original.toList();
    int at = 0;
    while (at < left.size() && at < right.size() && left.get(at).equals(right.get(at))) {
      at++;
    }
    assertThat(part(left, at)).as(name + ", line " + (at + 1)).isEqualTo(part(right, at));
  }

  private static List<String> part(List<String> lines, int at) {
    return lines.size() == at
        ? List.of()
        : lines.subList(Math.max(0, at - 2), Math.min(lines.size(), at + 2));
  }

  private static List<String> messages(ProblemCollector problems) {
    return problems.list().stream()
        .map(problem -> problem.message().replaceAll("scene:\\d+:\\d+", "there"))
        .toList();
  }

  @ParameterizedTest
  @MethodSource
  void scenes(Path scene) throws IOException {
    hold(scene.toString(), Files.readAllBytes(scene));
  }

  /**
   * Random documents, each also in the other encodings with characters in them that XML cannot
   * have: a control character, a carriage return, and half of a surrogate pair.
   */
  @ParameterizedTest
  @ValueSource(ints = {0, 20, 40, 60, 80, 100})
  void randomDocuments(int first) throws IOException {
    for (int seed = first; seed < first + 20; seed++) {
      String scene = RandomScene.of(seed, CATALOGUE);
      byte[] bytes = scene.getBytes(StandardCharsets.UTF_8);
      XmlDocument document = document(bytes);
      assertThat(document.faults()).as("seed " + seed).isEmpty();
      hold("seed " + seed, bytes);
      String json = SceneFormat.JSON.text(document, CATALOGUE, new ProblemCollector());
      String odd = json.replace("$$", "\\ud800").replace("$", "\\u0001");
      hold("JSON of seed " + seed, odd.replace("\u2028", "\\r").getBytes(StandardCharsets.UTF_8));
      String vrml = SceneFormat.CLASSIC.text(document, CATALOGUE, new ProblemCollector());
      String raw = vrml.replace('$', '\u0001').replace('\u2028', '\r');
      hold("ClassicVRML of seed " + seed, raw.getBytes(StandardCharsets.UTF_8));
    }
  }
}
