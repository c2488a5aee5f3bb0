package org.selectiverenderer.models;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.lwjgl.assimp.AIExportDataBlob;
import org.lwjgl.assimp.AIScene;
import org.lwjgl.assimp.Assimp;
import org.lwjgl.system.MemoryUtil;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.NodeTraversal;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;

/** Models that Assimp reads keep their nodes, views, animations and pictures as scenes. */
class ImportedSceneTest {
  private static final NodeCatalogue CATALOGUE = NodeCatalogue.load();

  /** A pivot above a triangle that an animation turns, and a camera. */
  private static final String COLLADA =
      """
      <?xml version="1.0" encoding="utf-8"?>
      <COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
       <asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
       <library_cameras><camera id="eye"><optics><technique_common><perspective>
        <yfov>45</yfov><aspect_ratio>2</aspect_ratio><znear>1</znear><zfar>9</zfar>
        </perspective></technique_common></optics></camera></library_cameras>
       <library_lights><light id="lamp"><technique_common><point><color>1 0.5 0</color>
        <constant_attenuation>0</constant_attenuation>
        <quadratic_attenuation>2</quadratic_attenuation></point></technique_common></light>
       </library_lights>
       <library_geometries><geometry id="g" name="leaf"><mesh>
        <source id="p"><float_array id="pa" count="9">0 0 0 100 0 0 0 100 0</float_array>
         <technique_common><accessor source="#pa" count="3" stride="3">
         <param name="X" type="float"/><param name="Y" type="float"/>
         <param name="Z" type="float"/></accessor></technique_common></source>
        <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
        <triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p>
        </triangles></mesh></geometry></library_geometries>
       <library_animations><animation id="a">
        <source id="t"><float_array id="ta" count="2">0 2</float_array><technique_common>
         <accessor source="#ta" count="2"><param name="TIME" type="float"/></accessor>
         </technique_common></source>
        <source id="o"><float_array id="oa" count="6">0 0 0 300 0 0</float_array>
         <technique_common><accessor source="#oa" count="2" stride="3">
         <param name="X" type="float"/><param name="Y" type="float"/>
         <param name="Z" type="float"/></accessor></technique_common></source>
        <source id="i"><Name_array id="ia" count="2">LINEAR LINEAR</Name_array>
         <technique_common><accessor source="#ia" count="2"><param name="INTERPOLATION"
         type="name"/></accessor></technique_common></source>
        <sampler id="s"><input semantic="INPUT" source="#t"/><input semantic="OUTPUT"
         source="#o"/><input semantic="INTERPOLATION" source="#i"/></sampler>
        <channel source="#s" target="door/move"/></animation></library_animations>
       <library_visual_scenes><visual_scene id="scene">
        <node id="door" name="door"><translate sid="move">0 0 0</translate>
         <node id="handle" name="handle"><translate>0 50 0</translate>
          <instance_geometry url="#g"/></node>
         <node id="knob" name="knob"><instance_geometry url="#g"/></node></node>
        <node id="stand" name="stand"><translate>0 0 500</translate>
         <instance_camera url="#eye"/><instance_light url="#lamp"/></node>
       </visual_scene></library_visual_scenes>
       <scene><instance_visual_scene url="#scene"/></scene>
      </COLLADA>
      """;

  @TempDir Path folder;

  /** A lamp 1 m above the floor, in centimetres. */
  private static final String LAMP =
      """
        ; FBX 7.4.0 project file
        FBXHeaderExtension:  {
        	FBXHeaderVersion: 1003
        	FBXVersion: 7400
        }
        GlobalSettings:  {
        	Version: 1000
        	Properties70:  {
        		P: "UnitScaleFactor", "double", "Number", "",1
        	}
        }
        Objects:  {
        	NodeAttribute: 1, "NodeAttribute::lamp", "Light" {
        		Properties70:  {
        			P: "LightType", "enum", "", "",0
        			P: "Intensity", "Number", "", "A",100
        			P: "DecayType", "enum", "", "",2
        			P: "DecayStart", "Number", "", "A",50
        		}
        		TypeFlags: "Light"
        		GeometryVersion: 124
        	}
        	Model: 2, "Model::lamp", "Light" {
        		Version: 232
        		Properties70:  {
        			P: "Lcl Translation", "Lcl Translation", "", "A",0,100,0
        		}
        	}
        }
        Connections:  {
        	C: "OO",2,0
        	C: "OO",1,2
        }
        """;

  private final ProblemCollector problems = new ProblemCollector();

  private X3dFile read(String name, byte[] content) throws IOException {
    Path file = Files.write(folder.resolve(name), content);
    return new X3dReader(CATALOGUE).read(file, problems);
  }

  private static List<ParsedNode> all(X3dFile file, String type) {
    List<ParsedNode> found = new ArrayList<>();
    NodeTraversal.visit(
        file.allNodes(),
        node -> {
          if (node.type().name().equals(type)) {
            found.add(node);
          }
        });
    return found;
  }

  private static ParsedNode named(X3dFile file, String def) {
    return all(file, "Transform").stream()
        .filter(node -> def.equals(node.name()))
        .findFirst()
        .orElseThrow();
  }

  private List<String> messages() {
    return problems.list().stream().map(Problem::message).toList();
  }

  @Test
  void nodesOfColladaKeepTheirNamesAndPlaces() throws IOException {
    X3dFile file = read("door.dae", COLLADA.getBytes(StandardCharsets.UTF_8));

    assertThat(messages()).isEmpty();
    ParsedNode handle = named(file, "handle");
    assertThat(handle.floats("translation")[1] * unit(file)).isCloseTo(0.5f, within(1e-5f));
    assertThat(named(file, "door").nodes("children")).hasSize(2);
    assertThat(all(file, "Shape")).as("the same mesh is written once").hasSize(1);
  }

  /** Returns by what numbers inside of the root are multiplied. */
  private static float unit(X3dFile file) {
    ParsedNode top = file.nodes().get(0);
    return top.type().name().equals("Transform") && !"door".equals(top.name())
        ? top.floats("scale")[0]
        : 1;
  }

  @Test
  void camerasAndLightsOfColladaAreThere() throws IOException {
    X3dFile file = read("door.dae", COLLADA.getBytes(StandardCharsets.UTF_8));

    ParsedNode camera = all(file, "Viewpoint").get(0);
    assertThat(camera.string("description")).isEqualTo("stand");
    assertThat(camera.number("fieldOfView")).isCloseTo((float) (Math.PI / 4), within(1e-4f));
    ParsedNode light = all(file, "PointLight").get(0);
    assertThat(light.floats("color")).containsExactly(1, 0.5f, 0);
    assertThat(light.floats("attenuation")).containsExactly(0, 0, 2);
  }

  /** Blender writes lamps in watts, 500 where a hundredth would make all white at 1 m. */
  @Test
  void lampsInWattsHaveTheRadiantIntensityThatGltfGivesThem() throws IOException {
    String watts =
        COLLADA
            .replace("1 0.5 0</color>", "500 250 0</color>")
            .replace("<quadratic_attenuation>2<", "<quadratic_attenuation>0.0016<");
    assertThat(watts).contains("500 250 0", "0.0016");

    X3dFile file = read("door.dae", watts.getBytes(StandardCharsets.UTF_8));

    ParsedNode light = all(file, "PointLight").get(0);
    assertThat(light.number("intensity")).isCloseTo((float) (500 / (4 * Math.PI)), within(1e-3f));
    assertThat(light.floats("color")).containsExactly(1, 0.5f, 0);
    // In the coordinates of the light, which are those of the file's unit of length.
    assertThat(light.floats("attenuation")).startsWith(0, 0);
    assertThat(light.floats("attenuation")[2]).isCloseTo(unit(file) * unit(file), within(1e-6f));
    assertThat(unit(file)).isLessThan(1);
    assertThat(messages())
        .singleElement()
        .asString()
        .contains("watts")
        .contains("X3D has no exposure");
  }

  @Test
  void animationsOfColladaMoveTheirNodes() throws IOException {
    X3dFile file = read("door.dae", COLLADA.getBytes(StandardCharsets.UTF_8));

    assertThat(
            all(file, "TimeSensor")
                .get(0)
                .value(all(file, "TimeSensor").get(0).type().indexOf("cycleInterval")))
        .isEqualTo(2.0);
    ParsedNode moving = all(file, "PositionInterpolator").get(0);
    float[] values = moving.floats("keyValue");
    assertThat(values[values.length - 3] * unit(file)).isCloseTo(3f, within(1e-4f));
    assertThat(file.routes().stream().map(route -> String.valueOf(route.to().name())))
        .contains("door");
  }

  /** Returns a model in another format, as Assimp writes it. */
  private static byte[] exported(String format, String hint, byte[] model) {
    ByteBuffer bytes = MemoryUtil.memAlloc(model.length).put(model).flip();
    AIScene scene = Objects.requireNonNull(Assimp.aiImportFileFromMemory(bytes, 0, hint));
    MemoryUtil.memFree(bytes);
    AIExportDataBlob blob = Objects.requireNonNull(Assimp.aiExportSceneToBlob(scene, format, 0));
    byte[] result = new byte[blob.data().remaining()];
    blob.data().get(result);
    Assimp.aiReleaseExportBlob(blob);
    Assimp.aiReleaseImport(scene);
    return result;
  }

  @ParameterizedTest
  @ValueSource(strings = {"fbx", "fbxa"})
  void nodesOfFbxKeepTheirNames(String format) throws IOException {
    byte[] fbx = exported(format, "dae", COLLADA.getBytes(StandardCharsets.UTF_8));

    X3dFile file = read("door.fbx", fbx);

    assertThat(messages()).isEmpty();
    assertThat(named(file, "door").nodes("children")).hasSizeGreaterThanOrEqualTo(2);
    assertThat(all(file, "Coordinate")).isNotEmpty();
  }

  @Test
  void groupsOfObjAreParts() throws IOException {
    String obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\no seat\nf 1 2 3\no back\nf 3 2 1\n";

    X3dFile file = read("chair.obj", obj.getBytes(StandardCharsets.UTF_8));

    assertThat(all(file, "Transform").stream().map(ParsedNode::name)).contains("seat", "back");
    assertThat(messages()).isEmpty();
  }

  @Test
  void picturesInsideOfAModelBecomeDataUrls() throws IOException {
    byte[] png = {(byte) 0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 0, 0, 0, 0, 0};
    String gltf =
        """
        {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
         "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
         "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
         "textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,%s"}],
         "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",
           "min":[0,0,0],"max":[1,1,0]},
          {"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}],
         "bufferViews":[{"buffer":0,"byteLength":36},
           {"buffer":0,"byteOffset":36,"byteLength":24}],
         "buffers":[{"byteLength":60,"uri":"data:application/octet-stream;base64,%s"}]}"""
            .formatted(Base64.getEncoder().encodeToString(png), triangle());
    byte[] fbx = exported("fbx", "gltf", gltf.getBytes(StandardCharsets.UTF_8));

    X3dFile file = read("leaf.fbx", fbx);

    assertThat(all(file, "ImageTexture").get(0).strings("url"))
        .containsExactly("data:image/png;base64," + Base64.getEncoder().encodeToString(png));
    assertThat(messages()).isEmpty();
  }

  private static String triangle() {
    ByteBuffer bytes = ByteBuffer.allocate(60).order(ByteOrder.LITTLE_ENDIAN);
    for (float value : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1}) {
      bytes.putFloat(value);
    }
    return Base64.getEncoder().encodeToString(bytes.array());
  }

  @Test
  void aModelThatIsReadWithoutItsFolderReadsNoFileOfTheWorkingDirectory() throws IOException {
    String obj = "mtllib pom.xml\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";
    Path file = Files.writeString(folder.resolve("chair.obj"), obj);

    X3dFile scene;
    try (InputStream in = Files.newInputStream(file)) {
      scene = new X3dReader(CATALOGUE).read("chair.obj", in, Files.size(file), problems);
    }

    assertThat(all(scene, "Shape")).hasSize(1);
    assertThat(messages())
        .containsExactly(
            "url 'pom.xml' is another file, and the model is read without its folder; what it"
                + " defines is left out");
  }

  @Test
  void nodesWithoutMeshesGetNoFigureOfBones() throws IOException {
    String without = COLLADA.replace("<instance_geometry url=\"#g\"/>", "");

    X3dFile file = read("door.dae", without.getBytes(StandardCharsets.UTF_8));

    assertThat(all(file, "Shape")).isEmpty();
    assertThat(all(file, "Viewpoint")).hasSize(1);
    assertThat(messages()).isEmpty();
  }

  @Test
  void pointsOfPlyAreAPointSetWithTheirColours() throws IOException {
    String ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
            + "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            + "end_header\n0 0 0 255 0 0\n1 0 0 0 255 0\n1 0 0 0 0 255\n";

    X3dFile file = read("cloud.ply", ply.getBytes(StandardCharsets.UTF_8));

    assertThat(messages()).isEmpty();
    assertThat(all(file, "PointSet")).hasSize(1);
    assertThat(all(file, "Coordinate").get(0).floats("point"))
        .containsExactly(0, 0, 0, 1, 0, 0, 1, 0, 0);
    assertThat(all(file, "ColorRGBA").get(0).floats("color"))
        .containsExactly(1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1);
    assertThat(all(file, "Viewpoint").get(0).bool("viewAll")).isTrue();
  }

  @Test
  void pointsOfBinaryPlyAreAPointSet() throws IOException {
    byte[] header =
        ("ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
                + "property float y\nproperty float z\nend_header\n")
            .getBytes(StandardCharsets.UTF_8);
    ByteBuffer ply = ByteBuffer.allocate(header.length + 24).order(ByteOrder.LITTLE_ENDIAN);
    ply.put(header).putFloat(1).putFloat(2).putFloat(3).putFloat(4).putFloat(5).putFloat(6);

    X3dFile file = read("cloud.ply", ply.array());

    assertThat(messages()).isEmpty();
    assertThat(all(file, "Coordinate").get(0).floats("point")).containsExactly(1, 2, 3, 4, 5, 6);
    assertThat(all(file, "UnlitMaterial")).hasSize(1);
  }

  @Test
  void aPlyWhoseFacesAreCutOffIsNoCloudOfPoints() throws IOException {
    String ply =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            + "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
            + "end_header\n0 0 0\n1 0 0\n0 1 0\n";

    X3dFile file = read("cut.ply", ply.getBytes(StandardCharsets.UTF_8));

    assertThat(file.nodes()).isEmpty();
    assertThat(messages()).singleElement().asString().contains("damaged or cut off");
  }

  @Test
  void nodesOfColladaHaveTheirNamesNotTheirIds() throws IOException {
    String collada =
        COLLADA
            .replace("id=\"door\" name=\"door\"", "id=\"door\" name=\"Haustür\"")
            .replace("id=\"handle\" name=\"handle\"", "id=\"handle\" name=\"part\"")
            .replace("id=\"knob\" name=\"knob\"", "id=\"knob\" name=\"part\"")
            .replace("id=\"stand\" name=\"stand\"", "id=\"stand\"");

    X3dFile file = read("door.dae", collada.getBytes(StandardCharsets.UTF_8));

    assertThat(messages()).isEmpty();
    assertThat(all(file, "Transform").stream().map(ParsedNode::name))
        .contains("Haustür", "part", "part_1", "stand");
    assertThat(all(file, "Viewpoint").get(0).string("description")).isEqualTo("stand");
    assertThat(file.routes().stream().map(route -> String.valueOf(route.to().name())))
        .contains("Haustür");
  }

  @Test
  void lightsOfFbxFallOffByMetres() throws IOException {
    X3dFile file = read("lamp.fbx", LAMP.getBytes(StandardCharsets.UTF_8));

    assertThat(messages()).isEmpty();
    assertThat(named(file, "lamp").floats("translation")[1]).isCloseTo(1, within(1e-5f));
    float[] attenuation = all(file, "PointLight").get(0).floats("attenuation");
    // Assimp's 2 / 50 cm squared
    assertThat(attenuation[2]).isCloseTo(8, within(1e-3f));
  }

  /** X3D measures from a light in the light's own coordinates (X3D 4.0, 17.2.1.4). */
  @Test
  void theScaleOfNodesDoesNotChangeHowLightsFallOff() throws IOException {
    String scaled =
        LAMP.replace(
            "P: \"Lcl Translation\"",
            "P: \"Lcl Scaling\", \"Lcl Scaling\", \"\", \"A\",100,100,100\n\t\t\tP: \"Lcl Translation\"");

    X3dFile file = read("lamp.fbx", scaled.getBytes(StandardCharsets.UTF_8));

    assertThat(named(file, "lamp").floats("scale")[0]).isCloseTo(100, within(1e-3f));
    ParsedNode light = all(file, "PointLight").get(0);
    assertThat(light.floats("attenuation")[2]).isCloseTo(80_000, within(10f));
    assertThat(light.number("radius")).isCloseTo(10_000, within(1f));
  }
}
