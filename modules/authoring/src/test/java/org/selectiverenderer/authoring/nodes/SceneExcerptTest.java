package org.selectiverenderer.authoring.nodes;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.read.X3dReader;
import org.selectiverenderer.x3d.source.DocumentElement;

class SceneExcerptTest {
  private static final String SCENE =
      """
      <X3D><Scene>
        <ProtoDeclare name='Leg'><ProtoBody><Shape><Box/></Shape></ProtoBody></ProtoDeclare>
        <ProtoDeclare name='Other'><ProtoBody><Shape><Box/></Shape></ProtoBody></ProtoDeclare>
        <ProtoDeclare name='Chair'><ProtoBody><Group>
          <ProtoDeclare name='Own'><ProtoBody><Shape><Cone/></Shape></ProtoBody></ProtoDeclare>
          <ProtoInstance name='Leg'/><ProtoInstance name='Own'/>
        </Group></ProtoBody></ProtoDeclare>
        <Shape DEF='Ball'><Appearance DEF='Red'><Material DEF='M'/></Appearance><Sphere/></Shape>
        <Switch DEF='S' whichChoice='0'>
          <ProtoInstance name='Chair'/>
          <Shape USE='Ball'/>
          <Group><Shape><Appearance USE='Red'/></Shape><Shape><Appearance USE='Red'/></Shape></Group>
        </Switch>
      </Scene></X3D>
      """;

  private final SceneDocument document;

  SceneExcerptTest() throws IOException {
    document = SceneDocument.of("scene.x3d", SCENE.getBytes(StandardCharsets.UTF_8));
  }

  private String excerpt(int choice) {
    DocumentElement node = document.tree().orElseThrow().named("S").orElseThrow();
    String text = SceneExcerpt.of(document, node.children().get(choice)).orElseThrow();
    ProblemCollector problems = new ProblemCollector();
    X3dFile read = new X3dReader(NodeCatalogue.load()).read("excerpt", text, problems);
    assertThat(problems.list()).isEmpty();
    assertThat(read.nodes()).hasSize(1);
    return text;
  }

  @Test
  void theScenesOfInstancesDeclareWhatTheyNeed() {
    assertThat(excerpt(0)).contains("name='Leg'", "name='Chair'").doesNotContain("'Other'");
  }

  @Test
  void whatIsTakenOverIsWrittenOutOnce() {
    assertThat(excerpt(1)).contains("<Shape DEF='Ball'>");
    assertThat(excerpt(2))
        .contains("<Appearance DEF='Red'><Material DEF='M'/></Appearance>")
        .containsOnlyOnce("USE='Red'");
  }
}
