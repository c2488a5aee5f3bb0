package org.selectiverenderer.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.testing.X3dDocument;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

class ModelWriterTest {
  @TempDir Path folder;

  private final ProblemCollector problems = new ProblemCollector();
  private final ModelReader reader = new ModelReader(NodeCatalogue.load());
  private final ModelWriter writer = new ModelWriter();

  private Model read(String content) throws IOException {
    Path file = folder.resolve("scenes/in.x3d");
    Files.createDirectories(file.getParent());
    Files.writeString(
        file, "<X3D profile='Immersive' version='3.3'><Scene>" + content + "</Scene></X3D>");
    return reader.read(file, problems).orElseThrow();
  }

  private Path write(Model model) throws IOException {
    Path target = Files.createDirectories(folder.resolve("out"));
    return Files.writeString(
        target.resolve("o.x3d"), writer.text(model, target, "o.x3d", "A 'test' & more <"));
  }

  @Test
  void whatIsWrittenReadsAsTheSameModel() throws IOException {
    Model model =
        read(
            "<Transform translation='1 2 3' rotation='1 1 0 0.7'><Shape><Appearance>"
                + "<Material diffuseColor='0.1 0.2 0.3' shininess='0.7'/></Appearance>"
                + "<Sphere radius='0.3'/></Shape><Shape><Cone/></Shape></Transform>");

    Model again = reader.read(write(model), problems).orElseThrow();

    assertThat(problems.list()).isEmpty();
    assertThat(again.parts()).hasSize(2);
    for (int i = 0; i < 2; i++) {
      assertThat(again.parts().get(i).mesh().polygons())
          .isEqualTo(model.parts().get(i).mesh().polygons());
      assertThat(again.parts().get(i).mesh().bounds())
          .usingComparatorWithPrecision(2e-5f)
          .containsExactly(model.parts().get(i).mesh().bounds());
    }
    assertThat(again.parts().get(0).appearance().node("material").floats("diffuseColor"))
        .containsExactly(0.1f, 0.2f, 0.3f);
  }

  @Test
  void anyXmlParserReadsIt() throws IOException {
    X3dDocument document = X3dDocument.read(write(read("<Shape><Sphere/></Shape>")));

    assertThat(document.dom().getDocumentElement().getAttribute("profile"))
        .isEqualTo("Interchange");
    assertThat(document.triangles()).isEqualTo(960);
    assertThat(document.elements("Normal")).hasSize(1);
  }

  @Test
  void facetsNeedNoNormals() throws IOException {
    X3dDocument document = X3dDocument.read(write(read("<Shape><Box/></Shape>")));

    assertThat(document.elements("Normal")).isEmpty();
    assertThat(document.elements("Coordinate").get(0).getAttribute("point").split("\\s+"))
        .as("eight corners, each once")
        .hasSize(24);
  }

  @Test
  void urlsLeadToTheSameFilesFromTheNewFolder() throws IOException {
    String text =
        Files.readString(
            write(
                read(
                    "<Shape><Appearance><ImageTexture url='\"textures/a.png\""
                        + " \"http://example.org/a.png\"'/></Appearance><Box/></Shape>")));

    assertThat(text).contains("url='\"../scenes/textures/a.png\" \"http://example.org/a.png\"'");
  }

  @Test
  void aSharedAppearanceIsUsedAgain() throws IOException {
    String text =
        Files.readString(
            write(
                read(
                    "<Shape><Appearance DEF='Look'><Material/></Appearance><Box/></Shape>"
                        + "<Shape><Appearance USE='Look'/><Sphere/></Shape>")));

    assertThat(text).contains("<Appearance DEF='Look'>").contains("<Appearance USE='Look'/>");
  }

  @Test
  void coloursPerVertexAreKept() throws IOException {
    Model model =
        read(
            "<Shape><IndexedFaceSet coordIndex='0 1 2 -1'><Coordinate point='0 0 0 1 0 0 0 1 0'/>"
                + "<Color color='1 0 0 0 1 0 0 0 1'/></IndexedFaceSet></Shape>");

    Model again = reader.read(write(model), problems).orElseThrow();

    assertThat(again.parts().get(0).mesh().colors())
        .containsExactly(model.parts().get(0).mesh().colors());
  }

  @Test
  void newMaterialsNeedTheNewVersion() throws IOException {
    assertThat(
            Files.readString(
                write(read("<Shape><Appearance><PhysicalMaterial/></Appearance><Box/></Shape>"))))
        .contains("version='4.0'");
  }

  @Test
  void theLocaleDoesNotMatter() throws IOException {
    Model model = read("<Shape><Sphere radius='0.123'/></Shape>");
    String here = writer.text(model, folder, "o.x3d", "d");
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.forLanguageTag("ar-EG"));
      assertThat(writer.text(model, folder, "o.x3d", "d")).isEqualTo(here);
    } finally {
      Locale.setDefault(before);
    }
  }
}
