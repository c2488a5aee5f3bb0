package org.selectiverenderer.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

/** OBJ as exporters write it who mean something else by its words than others do. */
class ObjDialectTest {
  private static final ModelReader reader = new ModelReader(NodeCatalogue.load());

  private static final String VTK = "# wavefront mtl file written by the visualization toolkit\n\n";

  private static final String TWO_TRIANGLES =
      "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n";

  @TempDir Path folder;

  private final ProblemCollector problems = new ProblemCollector();

  @AfterAll
  static void close() {
    reader.close();
  }

  private List<ModelPart> read(String materials, String mesh) throws IOException {
    Files.writeString(folder.resolve("m.mtl"), materials);
    Path file = Files.writeString(folder.resolve("model.obj"), mesh);
    List<ModelPart> parts = reader.read(file, problems).orElseThrow().parts();
    assertThat(problems.list()).isEmpty();
    return parts;
  }

  private static List<Float> transparencies(List<ModelPart> parts) {
    return parts.stream()
        .map(part -> part.appearance().node("material").number("transparency"))
        .toList();
  }

  /** VTK writes its opacity as Tr, and so do PyVista and ParaView, which use its exporter. */
  @ParameterizedTest
  @ValueSource(strings = {VTK, "# Created by Jmol 14.32.83  2023-01-07 08:24\n\n"})
  void trIsTheOpacityWhereVtkOrJmolWroteTheMaterials(String header) throws IOException {
    List<ModelPart> parts =
        read(
            header + "newmtl a\nKd 1 1 1\n Tr 1\nillum 3\nnewmtl b\r\nKd 0 0 1\r\n\tTr  0.25\r\n",
            TWO_TRIANGLES);

    assertThat(transparencies(parts)).containsExactly(0f, 0.75f);
  }

  @Test
  void trIsTheTransparencyElsewhere() throws IOException {
    List<ModelPart> parts =
        read("# by hand\nnewmtl a\nKd 1 1 1\nTr 0\nnewmtl b\nTr 0.25\n", TWO_TRIANGLES);

    assertThat(transparencies(parts)).containsExactly(0f, 0.25f);
  }

  @Test
  void namesThatBeginAsTrAreKeptInMaterialsOfVtk() throws IOException {
    List<ModelPart> parts =
        read(
            VTK + "newmtl Tr a\nKd 1 1 1\nmap_Kd Tr 1.png\nTr 1\n",
            "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl Tr a\nf 1/1 2/1 3/1\n");

    assertThat(transparencies(parts)).containsExactly(0f);
    assertThat(parts.get(0).appearance().node("texture").strings("url"))
        .containsExactly("Tr 1.png");
  }

  /** Assimp makes vertices without a colour black if the file has others with one. */
  @Test
  void aMeshWithoutColoursBesideOneWithColoursHasItsMaterial() throws IOException {
    List<ModelPart> parts =
        read(
            "newmtl a\nKd 1 0 0\nnewmtl b\nKd 0 1 0\n",
            "mtllib m.mtl\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\no one\nusemtl a\nf 1 2 3\n"
                + "v 0 0 1\nv 1 0 1\nv 0 1 1\no two\nusemtl b\nf 4 5 6\n");

    assertThat(parts).hasSize(2);
    assertThat(parts.get(0).mesh().colors()).isNotNull();
    assertThat(parts.get(1).mesh().colors()).isNull();
  }
}
