package org.selectiverenderer.models.gltf;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.x3d.read.ParsedNode;
import org.selectiverenderer.x3d.read.X3dFile;

class GltfMaterialTest extends GltfSceneTest {
  @Test
  void materialsBecomePhysicalMaterials() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"attributes\":{\"POSITION\":0},\"material\":0}",
            """
            ,"materials":[{"name":"brass","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.25,
             "emissiveFactor":[0.5,0,0],
             "pbrMetallicRoughness":{"baseColorFactor":[0.25,0.5,0.75,0.5],"metallicFactor":0.75}}]
            """);

    ParsedNode material = first(file, "PhysicalMaterial");
    assertThat(material.floats("baseColor")).containsExactly(0.25f, 0.5f, 0.75f);
    assertThat(material.number("metallic")).isEqualTo(0.75f);
    assertThat(material.number("roughness")).isEqualTo(1);
    assertThat(material.number("transparency")).isEqualTo(0.5f);
    assertThat(material.floats("emissiveColor")).containsExactly(0.5f, 0, 0);
    ParsedNode appearance = first(file, "Appearance");
    assertThat(appearance.string("alphaMode")).isEqualTo("MASK");
    assertThat(appearance.number("alphaCutoff")).isEqualTo(0.25f);
    assertThat(first(file, "IndexedTriangleSet").bool("solid")).isFalse();
  }

  @Test
  void anUnlitMaterialHasNoLight() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"attributes\":{\"POSITION\":0},\"material\":0}",
            ",\"materials\":[{\"extensions\":{\"KHR_materials_unlit\":{}}}]");

    assertThat(first(file, "UnlitMaterial").floats("emissiveColor")).containsExactly(1, 1, 1);
    assertThat(messages()).isEmpty();
  }

  @Test
  void anUnknownExtensionOfAMaterialIsTold() throws IOException {
    mesh(
        new GltfBuilder().triangle(),
        "{\"attributes\":{\"POSITION\":0},\"material\":0}",
        ",\"materials\":[{\"extensions\":{\"KHR_materials_sheen\":{}}}]");

    assertThat(messages())
        .containsExactly(
            "materials[0]: X3D has nothing like the extension KHR_materials_sheen,"
                + " which is left out");
  }

  @Test
  void picturesInTheFileBecomeDataUrlsAndCoordinatesAreTurnedUpright() throws IOException {
    GltfBuilder gltf = new GltfBuilder().triangle().floats("VEC2", 3, 0, 0, 1, 0, 0, 1);
    int picture = gltf.view(new byte[] {(byte) 0x89, 'P', 'N', 'G'}, 0);

    X3dFile file =
        mesh(
            gltf,
            "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"material\":0}",
            """
            ,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
             "textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071}],
             "images":[{"bufferView":%d,"mimeType":"image/png"}]"""
                .formatted(picture));

    ParsedNode texture = first(file, "ImageTexture");
    assertThat(texture.strings("url")).containsExactly("data:image/png;base64,iVBORw==");
    assertThat(texture.bool("repeatS")).isFalse();
    assertThat(texture.bool("repeatT")).isTrue();
    assertThat(first(file, "TextureCoordinate").floats("point")).containsExactly(0, 1, 1, 1, 0, 0);
  }

  @Test
  void texturesOfSeveralSetsAndTransformsAreTiedByNames() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder()
                .triangle()
                .floats("VEC2", 3, 0, 0, 1, 0, 0, 1)
                .floats("VEC2", 3, 0, 0, 0.5f, 0, 0, 0.5f),
            "{\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1,\"TEXCOORD_1\":2},\"material\":0}",
            """
            ,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"extensions":
              {"KHR_texture_transform":{"scale":[0.5,0.5],"offset":[0.5,0]}}}},
              "occlusionTexture":{"index":0,"texCoord":1}}],
             "textures":[{"source":0}],"images":[{"uri":"wood.png"}]""");

    ParsedNode material = first(file, "PhysicalMaterial");
    assertThat(material.string("baseTextureMapping")).isEqualTo("channel0");
    assertThat(material.string("occlusionTextureMapping")).isEqualTo("channel1");
    assertThat(first(file, "MultiTextureCoordinate").nodes("texCoord")).hasSize(2);
    ParsedNode transform = first(file, "TextureTransform");
    assertThat(transform.string("mapping")).isEqualTo("channel0");
    // (u, v) = (0, 0) is shown at (0.5, 0) in glTF: (s, t) = (0, 1) at (0.5, 1) in X3D
    assertThat(transform.floats("translation")).containsExactly(1, 1);
    assertThat(first(file, "ImageTexture").strings("url")).containsExactly("wood.png");
  }

  @Test
  void aMaterialOfDiffuseColourAndGlossinessIsOfNoMetal() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"attributes\":{\"POSITION\":0},\"material\":0}",
            """
            ,"materials":[{"extensions":{"KHR_materials_pbrSpecularGlossiness":
              {"diffuseFactor":[0.25,0.5,0.75,1],"glossinessFactor":0.75}}}]""");

    ParsedNode material = first(file, "PhysicalMaterial");
    assertThat(material.floats("baseColor")).containsExactly(0.25f, 0.5f, 0.75f);
    assertThat(material.number("metallic")).isZero();
    assertThat(material.number("roughness")).isEqualTo(0.25f);
    assertThat(messages()).singleElement().asString().contains("no equal in X3D");
  }

  @Test
  void texturesOfOnePictureAreOneImageTexture() throws IOException {
    X3dFile file =
        mesh(
            new GltfBuilder().triangle(),
            "{\"attributes\":{\"POSITION\":0},\"material\":0}",
            """
            ,"materials":[{"emissiveTexture":{"index":1},
              "pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
             "textures":[{"source":0},{"source":0}],"images":[{"uri":"data:image/png;base64,AAAA"}]
            """);

    ParsedNode material = first(file, "PhysicalMaterial");
    assertThat(material.node("emissiveTexture")).isNotNull().isSameAs(material.node("baseTexture"));
  }
}
