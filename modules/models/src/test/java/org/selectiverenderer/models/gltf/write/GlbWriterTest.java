package org.selectiverenderer.models.gltf.write;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.Problem;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.formats.image.PngEncoder;
import org.selectiverenderer.geometry.mesh.Mesh;
import org.selectiverenderer.models.Model;
import org.selectiverenderer.models.ModelReader;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;

/** Tests what scenes become in glTF. */
final class GlbWriterTest {
  private static final String BOX = "<Shape><Appearance><Material/></Appearance><Box/></Shape>";

  @TempDir Path folder;
  private final NodeCatalogue catalogue = NodeCatalogue.load();
  private final ProblemCollector problems = new ProblemCollector();

  @Test
  void modelReaderFindsTheSameTrianglesInTheSamePlace() throws IOException {
    Path scene =
        scene(
            """
            <Transform translation='1 2 3' rotation='0 1 0 0.5' scale='1 2 1' center='4 0 0'
                scaleOrientation='0 0 1 0.3'>
              <Shape><Appearance><Material diffuseColor='1 0 0'/></Appearance><Cone/></Shape>
              <Transform translation='0 5 0'><Shape><Sphere/></Shape></Transform>
            </Transform>
            """);
    Path glb = folder.resolve("scene.glb");
    Files.write(glb, bytes(scene, GlbWriter.Form.GLB));
    try (ModelReader reader = new ModelReader(catalogue)) {
      Model before = reader.read(scene, problems).orElseThrow();
      Model after = reader.read(glb, problems).orElseThrow();
      assertThat(after.polygons()).isEqualTo(before.polygons());
      for (int i = 0; i < 6; i++) {
        assertThat(bound(after, i)).isCloseTo(bound(before, i), within(1e-4f));
      }
    }
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void bothFormsHoldTheSameScene() throws IOException {
    Path scene = scene(BOX);
    JsonNode binary = read(scene);
    JsonNode text = new ObjectMapper().readTree(bytes(scene, GlbWriter.Form.GLTF));
    assertThat(text.get("accessors")).isEqualTo(binary.get("accessors"));
    assertThat(text.at("/buffers/0/uri").asText()).startsWith("data:application/octet-stream");
    assertThat(binary.at("/buffers/0/uri").isMissingNode()).isTrue();
  }

  @Test
  void defNamesNodesAndUseSharesMeshes() throws IOException {
    JsonNode gltf =
        read(scene("<Group DEF='Desk'><Shape DEF='S'><Box/></Shape><Shape USE='S'/></Group>"));
    assertThat(gltf.get("meshes")).hasSize(1);
    assertThat(gltf.get("nodes").findValuesAsText("name")).containsExactly("Desk", "S", "S");
    assertThat(gltf.get("nodes").findValuesAsText("mesh")).containsExactly("0", "0");
  }

  @Test
  void switchWritesItsChoiceWithItsMetadataAndTellsTheOthersOnce() throws IOException {
    String two =
        """
        <Switch whichChoice='1'>
          <MetadataSet name='SelectiveRendering' containerField='metadata'>
            <MetadataString name='schemas' value='"office"'/>
            <MetadataInteger name='n' value='3'/>
          </MetadataSet>
          <Group DEF='High'/><Group DEF='Low'/>
        </Switch>
        """;
    JsonNode gltf = read(scene(two + two.replace("DEF='", "DEF='B")));
    JsonNode node = gltf.at("/nodes/0/extras/x3d");
    assertThat(node.get("type").asText()).isEqualTo("Switch");
    assertThat(node.get("whichChoice").asInt()).isEqualTo(1);
    assertThat(node.at("/metadata/name").asText()).isEqualTo("SelectiveRendering");
    assertThat(node.at("/metadata/value/0/value/0").asText()).isEqualTo("office");
    assertThat(node.at("/metadata/value/1/value/0").asInt()).isEqualTo(3);
    assertThat(gltf.get("nodes")).hasSize(4);
    assertThat(gltf.at("/nodes/1/name").asText()).isEqualTo("Low");
    assertThat(gltf.at("/nodes/3/name").asText()).isEqualTo("BLow");
    assertThat(problems.list()).hasSize(1);
  }

  @Test
  void whatLosesNothingOfThePictureIsInformation() throws IOException {
    read(
        scene(
            "<NavigationInfo/><NavigationInfo/><Shape><Appearance><Material specularColor='1 0 0'/>"
                + "</Appearance><Box/></Shape>"));
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "glTF has nothing for NavigationInfo; this one and all others are left out",
            "glTF has neither a specularColor nor an ambientIntensity; highlights follow from the"
                + " roughness, which is that of shininess");
    assertThat(problems.any()).as("something that counts").isFalse();
  }

  @Test
  void whatGltfCannotHoldIsToldOncePerKindWithItsFirstPlace() throws IOException {
    read(scene("<Fog DEF='F'/><TouchSensor/><Fog/><TouchSensor/>" + BOX));
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "glTF has nothing for Fog; this one and all others are left out",
            "glTF has nothing for TouchSensor; this one and all others are left out");
    assertThat(problems.list().get(0).location().line()).isEqualTo(2);
  }

  @Test
  void colourOfAMaterialBecomesLinearAndThatOfAPhysicalMaterialStays() throws IOException {
    JsonNode gltf =
        read(
            scene(
                """
                <Shape><Appearance><Material diffuseColor='0.5 0 1' transparency='0.25'/>
                </Appearance><Box solid='false'/></Shape>
                <Shape><Appearance><PhysicalMaterial baseColor='0.5 0 1' metallic='0.25'
                  roughness='0.5'/></Appearance><Box/></Shape>
                <Shape><Appearance><UnlitMaterial emissiveColor='1 0 0'/></Appearance><Box/></Shape>
                """));
    JsonNode phong = gltf.at("/materials/0");
    assertThat(phong.at("/pbrMetallicRoughness/baseColorFactor/0").asDouble())
        .isCloseTo(0.21404, within(1e-4));
    assertThat(phong.at("/pbrMetallicRoughness/baseColorFactor/3").asDouble()).isEqualTo(0.75);
    assertThat(phong.get("alphaMode").asText()).isEqualTo("BLEND");
    assertThat(phong.get("doubleSided").asBoolean()).isTrue();
    assertThat(gltf.at("/materials/1/pbrMetallicRoughness/baseColorFactor/0").asDouble())
        .isEqualTo(0.5);
    assertThat(gltf.at("/materials/1/pbrMetallicRoughness/metallicFactor").asDouble())
        .isEqualTo(0.25);
    assertThat(gltf.at("/materials/2/extensions/KHR_materials_unlit").isObject()).isTrue();
    assertThat(gltf.get("extensionsUsed").get(0).asText()).isEqualTo("KHR_materials_unlit");
  }

  @Test
  void viewpointsAndLightsAreWritten() throws IOException {
    JsonNode gltf =
        read(
            scene(
                """
                <Viewpoint DEF='V' description='Door' position='0 1 5' fieldOfView='0.5'/>
                <Viewpoint viewAll='true'/><OrthoViewpoint fieldOfView='-2 -1 2 1'/>
                <PointLight intensity='0.5' radius='7'/><SpotLight beamWidth='1.5'
                  cutOffAngle='1.5'/><DirectionalLight direction='1 0 0'/>
                """));
    assertThat(gltf.at("/cameras/0/perspective/yfov").asDouble()).isEqualTo(0.5);
    assertThat(gltf.at("/cameras/0/name").asText()).isEqualTo("Door");
    assertThat(gltf.at("/cameras/1/orthographic/xmag").asDouble()).isEqualTo(2);
    assertThat(gltf.get("cameras")).hasSize(2);
    JsonNode lights = gltf.at("/extensions/KHR_lights_punctual/lights");
    assertThat(lights.findValuesAsText("type")).containsExactly("point", "spot", "directional");
    assertThat(lights.at("/1/spot/innerConeAngle").asDouble())
        .isLessThan(lights.at("/1/spot/outerConeAngle").asDouble());
  }

  @Test
  void routedInterpolatorsBecomeAnAnimation() throws IOException {
    JsonNode gltf =
        read(
            scene(
                """
                <TimeSensor DEF='T' cycleInterval='4' loop='true'/>
                <OrientationInterpolator DEF='O' key='0 0.5 0.5 1'
                  keyValue='0 1 0 0 0 1 0 1 0 1 0 2 0 1 0 3'/>
                <Transform DEF='Door' center='1 0 0'><Shape><Box/></Shape></Transform>
                <ROUTE fromNode='T' fromField='fraction_changed' toNode='O'
                  toField='set_fraction'/>
                <ROUTE fromNode='O' fromField='value_changed' toNode='Door'
                  toField='set_rotation'/>
                """));
    JsonNode channel = gltf.at("/animations/0/channels/0/target");
    assertThat(gltf.at("/nodes/" + channel.get("node").asInt() + "/name").asText())
        .isEqualTo("Door");
    assertThat(channel.get("path").asText()).isEqualTo("rotation");
    int input = gltf.at("/animations/0/samplers/0/input").asInt();
    assertThat(gltf.at("/accessors/" + input + "/max/0").asDouble()).isEqualTo(4);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void pixelTextureIsEmbeddedAsPngWithItsTransform() throws IOException {
    JsonNode gltf =
        read(
            scene(
                """
                <Shape><Appearance><Material/><PixelTexture image='1 1 4 0xff000080'
                  repeatS='false'/><TextureTransform scale='2 3' translation='0.5 0.25'/>
                </Appearance><Box/></Shape>
                """));
    assertThat(gltf.at("/images/0/mimeType").asText()).isEqualTo("image/png");
    assertThat(gltf.at("/materials/0/alphaMode").asText()).isEqualTo("BLEND");
    JsonNode moved =
        gltf.at(
            "/materials/0/pbrMetallicRoughness/baseColorTexture/extensions/KHR_texture_transform");
    assertThat(moved.at("/scale/1").asDouble()).isEqualTo(3);
    assertThat(moved.at("/offset/0").asDouble()).isEqualTo(1);
    assertThat(moved.at("/offset/1").asDouble()).isEqualTo(1 - 3 - 0.75);
    assertThat(gltf.at("/samplers/0/wrapS").asInt()).isEqualTo(33071);
    assertThat(gltf.at("/samplers/0").has("magFilter")).isFalse();
  }

  @Test
  void texturePropertiesBecomeASampler() throws IOException {
    JsonNode gltf =
        read(
            scene(
                """
                <Shape><Appearance><Material/><PixelTexture image='1 1 3 0xff0000'>
                  <TextureProperties magnificationFilter='NEAREST_PIXEL'
                    minificationFilter='AVG_PIXEL_NEAREST_MIPMAP' boundaryModeS='MIRRORED_REPEAT'
                    boundaryModeT='CLAMP_TO_EDGE'/></PixelTexture></Appearance><Box/></Shape>
                """));
    JsonNode sampler = gltf.at("/samplers/0");
    assertThat(sampler.at("/magFilter").asInt()).isEqualTo(9728);
    assertThat(sampler.at("/minFilter").asInt()).isEqualTo(9985);
    assertThat(sampler.at("/wrapS").asInt()).isEqualTo(33648);
    assertThat(sampler.at("/wrapT").asInt()).isEqualTo(33071);
  }

  @Test
  void inlinesAreExpandedInMetresAndThoseOfThemselvesAreReported() throws IOException {
    Files.writeString(
        folder.resolve("part.x3d"),
        "<X3D version='4.0' profile='Full'><head><unit category='length' name='cm'"
            + " conversionFactor='0.01'/></head><Scene>"
            + BOX
            + "<Inline url='\"part.x3d\"'/></Scene></X3D>");
    JsonNode gltf = read(scene("<Inline DEF='I' url='\"part.x3d\"'/>"));
    assertThat(gltf.get("meshes")).hasSize(1);
    assertThat(gltf.get("nodes").findValue("scale").get(0).asDouble()).isEqualTo(0.01);
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly("the Inline names a file that contains it; it is left out");
  }

  @Test
  void nestedUsesBeyondTheLimitAreRefusedInOneSentence() throws IOException {
    StringBuilder nested = new StringBuilder("<Group DEF='G0'/>");
    for (int i = 1; i < 30; i++) {
      String use = "<Group USE='G" + (i - 1) + "'/>";
      nested.append("<Group DEF='G").append(i).append("'>").append(use).append(use);
      nested.append("</Group>");
    }
    Optional<byte[]> bytes = tryBytes(scene(nested.toString()), GlbWriter.Form.GLB);
    assertThat(bytes).isEmpty();
    assertThat(problems.list().get(0).message()).endsWith("is the limit; nothing is written");
  }

  @Test
  void aFurtherSetOfTextureCoordinatesIsThatOfTheTexturesThatNameIt() throws IOException {
    JsonNode gltf = read(scene(twoSets("second", "second")));
    JsonNode attributes = gltf.at("/meshes/0/primitives/0/attributes");
    assertThat(floats(scene(twoSets("second", "second")), attributes.get("TEXCOORD_0").asInt()))
        .startsWith(0, 1, 1, 1);
    assertThat(floats(scene(twoSets("second", "second")), attributes.get("TEXCOORD_1").asInt()))
        .startsWith(0.5f, 0.75f, 0.25f, 0.5f);
    JsonNode material = gltf.at("/materials/0");
    JsonNode base = material.at("/pbrMetallicRoughness/baseColorTexture");
    assertThat(base.has("texCoord")).as("set 0 is the default").isFalse();
    assertThat(base.has("extensions")).as("a transform of the first set").isFalse();
    JsonNode occlusion = material.get("occlusionTexture");
    assertThat(occlusion.get("texCoord").asInt()).isEqualTo(1);
    assertThat(occlusion.at("/extensions/KHR_texture_transform/scale/0").asDouble()).isEqualTo(2);
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aMappingThatNothingHasIsThatOfTheFirstSet() throws IOException {
    JsonNode gltf = read(scene(twoSets("second", "third")));
    assertThat(gltf.at("/materials/0/occlusionTexture").has("texCoord")).isFalse();
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void texturesOfGeneratedCoordinatesAreTold() throws IOException {
    JsonNode gltf =
        read(
            scene(
                """
                <Shape><Appearance><Material/><PixelTexture image='1 1 3 0xff0000'/></Appearance>
                  <IndexedFaceSet coordIndex='0 1 2 -1'><Coordinate point='0 0 0 1 0 0 0 1 0'/>
                    <TextureCoordinateGenerator mode='SPHERE'/></IndexedFaceSet></Shape>
                """));
    assertThat(gltf.at("/materials/0/pbrMetallicRoughness").has("baseColorTexture")).isFalse();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(
            "glTF has no TextureCoordinateGenerator; textures with coordinates that are generated"
                + " or not of two dimensions are left out");
  }

  @Test
  void modelsKeepTheirSetsOfTextureCoordinates() throws IOException {
    Files.write(folder.resolve("two.glb"), bytes(scene(twoSets("b", "b")), GlbWriter.Form.GLB));
    JsonNode gltf = read(folder.resolve("two.glb"));
    assertThat(gltf.at("/meshes/0/primitives/0/attributes").has("TEXCOORD_1")).isTrue();
    assertThat(gltf.at("/materials/0/occlusionTexture/texCoord").asInt()).isEqualTo(1);
  }

  @Test
  void otherPicturesBecomePng() throws IOException {
    Files.writeString(folder.resolve("sky.hdr"), "#?RADIANCE");
    JsonNode gltf = read(scene(picture("sky.hdr")));
    assertThat(gltf.at("/images/0/mimeType").asText()).isEqualTo("image/png");
    assertThat(gltf.at("/materials/0/pbrMetallicRoughness").has("baseColorTexture")).isTrue();
    assertThat(problems.list()).isEmpty();
  }

  @Test
  void aPictureThatCannotBecomePngIsTold() throws IOException {
    Files.writeString(folder.resolve("sky.webp"), "RIFF");
    JsonNode gltf = read(scene(picture("sky.webp")));
    assertThat(gltf.has("images")).isFalse();
    assertThat(problems.list())
        .extracting(Problem::message)
        .containsExactly(folder.resolve("sky.webp") + " is no picture; the texture is left out");
  }

  /** Returns a shape of two sets of texture coordinates with a texture for each. */
  private static String twoSets(String name, String wanted) {
    return """
        <Shape><Appearance><PhysicalMaterial baseTextureMapping='first'
            occlusionTextureMapping='%s'>
          <PixelTexture image='1 1 3 0xff0000' containerField='baseTexture'/>
          <PixelTexture image='1 1 3 0xff8000' containerField='occlusionTexture'/>
        </PhysicalMaterial>
        <MultiTextureTransform containerField='textureTransform'>
          <TextureTransform mapping='first' containerField='textureTransform'/>
          <TextureTransform mapping='%s' scale='2 2' containerField='textureTransform'/>
        </MultiTextureTransform></Appearance>
        <IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/>
          <MultiTextureCoordinate>
            <TextureCoordinate mapping='first' point='0 0 1 0 0 1' containerField='texCoord'/>
            <TextureCoordinate mapping='%s' point='0.5 0.25 0.25 0.5 0 0'
              containerField='texCoord'/>
          </MultiTextureCoordinate></IndexedTriangleSet></Shape>
        """
        .formatted(wanted, name, name);
  }

  private static String picture(String url) {
    return """
        <Shape><Appearance><Material/><ImageTexture url='"%s"'/></Appearance><Box/></Shape>
        """
        .formatted(url);
  }

  @Test
  void metadataThatIsUsedTooOftenIsRefusedInOneSentence() throws IOException {
    StringBuilder nested = new StringBuilder("<Group DEF='G0'><MetadataString name='a' value='");
    nested.append("\"word\" ".repeat(20_000)).append("' containerField='metadata'/></Group>");
    for (int i = 1; i < 14; i++) {
      String use = "<Group USE='G" + (i - 1) + "'/>";
      nested.append("<Group DEF='G").append(i).append("'>").append(use).append(use);
      nested.append("</Group>");
    }
    assertThat(tryBytes(scene(nested.toString()), GlbWriter.Form.GLB)).isEmpty();
    assertThat(problems.list().get(0).message()).endsWith("is the limit; nothing is written");
  }

  @Test
  void textFormHoldsTheSameBytesWhateverTheSceneSays() throws IOException {
    Path scene =
        scene(
            "<WorldInfo title='\"uri\":\"data:application/octet-stream;base64,'/><Shape>"
                + "<IndexedTriangleSet index='0 1 2 "
                + "0 1 2 ".repeat(20_000)
                + "'><Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedTriangleSet></Shape>");
    byte[] glb = bytes(scene, GlbWriter.Form.GLB);
    JsonNode text = new ObjectMapper().readTree(bytes(scene, GlbWriter.Form.GLTF));
    String url = text.at("/buffers/0/uri").asText();
    int length = text.at("/buffers/0/byteLength").asInt();
    assertThat(Base64.getDecoder().decode(url.substring(url.indexOf(',') + 1)))
        .isEqualTo(Arrays.copyOfRange(glb, glb.length - length, glb.length));
  }

  @Test
  void emptySceneIsAValidDocument() throws IOException {
    JsonNode gltf = read(scene(""));
    assertThat(gltf.at("/asset/version").asText()).isEqualTo("2.0");
    assertThat(gltf.at("/scenes/0").isObject()).isTrue();
  }

  private static float bound(Model model, int side) {
    List<Float> sides = model.meshes().stream().map(Mesh::bounds).map(b -> b[side]).toList();
    return side < 3
        ? sides.stream().min(Float::compare).orElseThrow()
        : sides.stream().max(Float::compare).orElseThrow();
  }

  private GlbWriter writer() {
    return new GlbWriter(
        catalogue,
        ContentAccessPolicy.none(),
        file -> {
          if (file.name().endsWith(".webp")) {
            throw new IOException("is no picture");
          }
          return PngEncoder.small(1, 1, new byte[] {1, 2, 3});
        });
  }

  private Path scene(String nodes) throws IOException {
    return Files.writeString(
        folder.resolve("scene.x3d"),
        "<X3D version='4.0' profile='Full'><Scene>\n" + nodes + "</Scene></X3D>");
  }

  private byte[] bytes(Path scene, GlbWriter.Form form) throws IOException {
    return tryBytes(scene, form).orElseThrow();
  }

  private Optional<byte[]> tryBytes(Path scene, GlbWriter.Form form) throws IOException {
    X3dFile file = new X3dReader(catalogue).read(scene, problems);
    return writer().bytes(file, folder, form, problems);
  }

  /** Returns the numbers of an accessor. */
  private float[] floats(Path scene, int accessor) throws IOException {
    byte[] glb = bytes(scene, GlbWriter.Form.GLB);
    ByteBuffer file = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN);
    JsonNode gltf = new ObjectMapper().readTree(glb, 20, file.getInt(12));
    JsonNode view = gltf.at("/bufferViews/" + gltf.at("/accessors/" + accessor + "/bufferView"));
    float[] numbers = new float[view.get("byteLength").asInt() / 4];
    int at = 20 + file.getInt(12) + 8 + view.get("byteOffset").asInt();
    file.position(at).slice().order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer().get(numbers);
    return numbers;
  }

  private JsonNode read(Path scene) throws IOException {
    byte[] glb = bytes(scene, GlbWriter.Form.GLB);
    ByteBuffer header = ByteBuffer.wrap(glb).order(ByteOrder.LITTLE_ENDIAN);
    assertThat(header.getInt(8)).isEqualTo(glb.length);
    return new ObjectMapper().readTree(glb, 20, header.getInt(12));
  }

  @Test
  void aNegativeRadiusIsNoLimitAndOneOfZeroDarkAsTheRendererHasIt() throws IOException {
    JsonNode gltf = read(scene("<PointLight radius='-1'/><SpotLight radius='0'/>"));

    JsonNode lights = gltf.at("/extensions/KHR_lights_punctual/lights");
    assertThat(lights.at("/0/intensity").asDouble()).isEqualTo(1);
    assertThat(lights.get(0).has("range")).isFalse();
    assertThat(lights.at("/1/intensity").asDouble(1)).isZero();
  }

  @Test
  void theRangeOfALightIsItsRadiusInTheScene() throws IOException {
    JsonNode gltf =
        read(
            scene(
                "<Transform scale='3 3 3'><Group><PointLight radius='2'/></Group></Transform>"
                    + "<PointLight radius='2'/>"));

    JsonNode lights = gltf.at("/extensions/KHR_lights_punctual/lights");
    assertThat(lights.at("/0/range").asDouble()).isEqualTo(6);
    assertThat(lights.at("/1/range").asDouble()).isEqualTo(2);
  }
}
