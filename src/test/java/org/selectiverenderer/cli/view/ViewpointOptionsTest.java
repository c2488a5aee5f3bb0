package org.selectiverenderer.cli.view;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Viewpoints by their names. */
class ViewpointOptionsTest {
  @TempDir private Path temp;
  private SimulateTestCase folder;

  @BeforeEach
  void writeScene() {
    folder = new SimulateTestCase(temp);
    folder.scene(
        "scene.x3d",
        """
        <Viewpoint DEF='Door'/>
        <Viewpoint DEF='Desk' description='At the desk' position='4 0 10'/>
        <Viewpoint description='Window'/>
        <ProximitySensor DEF='Near' center='4 0 10' size='1 1 1'/>
        """);
  }

  private SimulateTestCase.Result run(String command, String... more) {
    String[] all = new String[more.length + 2];
    all[0] = command;
    all[1] = folder.path("scene.x3d").toString();
    System.arraycopy(more, 0, all, 2, more.length);
    return folder.run(all);
  }

  @Test
  void theyAreListedWithoutADisplay() {
    SimulateTestCase.Result result = run("run", "--viewpoints");
    assertThat(result.status()).isZero();
    assertThat(result.out().lines()).containsExactly("Door", "Desk\tAt the desk", "Window");
    assertThat(result.messages()).isEmpty();
  }

  @Test
  void aWrongNameIsToldWithTheRightOnes() {
    String path = folder.path("still.csv").toString();
    SimulateTestCase.Result result = run("simulate", "--path", path, "--viewpoint", "Desc");
    assertThat(result.status()).isEqualTo(2);
    assertThat(result.messages())
        .containsExactly(
            "selective-renderer simulate: --viewpoint 'Desc': the scene has no such viewpoint; "
                + "did you mean 'Desk'? It has Door, Desk ('At the desk'), 'Window'");
  }

  @Test
  void nameAndDescriptionAreKnownInAnyCase() {
    String path = folder.path("still.csv").toString();
    for (String name : new String[] {"Desk", "At the desk", "desk", "window"}) {
      assertThat(run("simulate", "--path", path, "--viewpoint", name).status()).isZero();
    }
  }
}
