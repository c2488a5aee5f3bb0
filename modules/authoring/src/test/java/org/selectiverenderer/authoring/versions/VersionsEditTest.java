package org.selectiverenderer.authoring.versions;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.EditRejectedException;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.DocumentEnrichment;
import org.selectiverenderer.authoring.file.DocumentFile;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.models.simplify.SimplificationTarget;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;

class VersionsEditTest {
  private static final String SCENE =
      "<X3D version='3.3'><Scene>\n  <Shape DEF='Ball'><Sphere/></Shape>\n</Scene></X3D>\n";

  @TempDir Path folder;

  private VersionsEdit plan(DocumentFile file) throws IOException {
    return VersionsEdit.plan(
            file.document().snapshot(),
            new VersionsEdit.Request(
                file.path(),
                "Ball",
                List.of(new SimplificationTarget.Polygons(100)),
                "inlineNodes"),
            NodeCatalogue.load(),
            new ProblemCollector())
        .orElseThrow();
  }

  @Test
  void versionsOfAnUnsavedSceneAreOneStepAndTheFileIsLeftAlone() throws IOException {
    DocumentFile file = DocumentFile.open(Files.writeString(folder.resolve("ball.x3d"), SCENE));
    SceneDocument document = file.document();
    document.type(0, 0, "<!-- not saved -->");
    VersionsEdit versions = plan(file);
    assertThat(versions.versions()).hasSize(2);
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
    versions.apply(document);
    assertThat(folder.resolve("inlineNodes/Ball_v2.x3d")).exists();
    assertThat(file.path()).usingCharset(StandardCharsets.UTF_8).hasContent(SCENE);
    assertThat(new DocumentEnrichment(document, NodeCatalogue.load()).switches().get(0).choices())
        .extracting(choice -> choice.url())
        .containsExactly("inlineNodes/Ball_v1.x3d", "inlineNodes/Ball_v2.x3d");
    assertThat(document.history().undoName()).contains("Make versions of Ball");
    document.history().undo();
    assertThat(document.text().toString()).isEqualTo("<!-- not saved -->" + SCENE);
  }

  @Test
  void aPlanOfAnotherTextIsNotApplied() throws IOException {
    DocumentFile file = DocumentFile.open(Files.writeString(folder.resolve("ball.x3d"), SCENE));
    VersionsEdit versions = plan(file);
    file.document().type(0, 0, " ");
    assertThatThrownBy(() -> versions.apply(file.document()))
        .isInstanceOf(EditRejectedException.class);
    assertThat(folder.resolve("inlineNodes")).doesNotExist();
  }

  @Test
  void aSwitchInASharedLineHasLinesOfItsOwn() throws IOException {
    String scene =
        "<X3D version='3.3'><Scene>\r\n    <Group DEF='Ball'><Shape><Sphere/></Shape></Group>\r\n"
            + "</Scene></X3D>";
    DocumentFile file = DocumentFile.open(Files.writeString(folder.resolve("ball.x3d"), scene));
    plan(file).apply(file.document());
    assertThat(file.document().text().toString())
        .isEqualTo(
            """
            <X3D version='3.3'><Scene>
                <Group DEF='Ball'><Switch DEF='Switch_Ball' whichChoice='0'>
                  <Inline DEF='Inline_Ball_v1' url='"inlineNodes/Ball_v1.x3d"'/>
                  <Inline DEF='Inline_Ball_v2' url='"inlineNodes/Ball_v2.x3d"'/>
                </Switch></Group>
            </Scene></X3D>"""
                .replace("\n", "\r\n"));
  }
}
