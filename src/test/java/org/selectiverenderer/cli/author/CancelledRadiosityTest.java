package org.selectiverenderer.cli.author;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.testing.Eventually;

/** Ctrl-C, or a session that logs out, while light is computed. */
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class CancelledRadiosityTest {
  private static final String SLAB_UNDER_A_LAMP =
      """
      <X3D profile='Immersive' version='4.0'><Scene>
        <PointLight location='0 3 0'/>
        <Transform translation='0 -0.5 0'><Shape>
          <Appearance><Material/></Appearance><Box size='8 0.01 8'/>
        </Shape></Transform>
        <Shape><Appearance><Material/></Appearance><Box size='1 1 1'/></Shape>
      </Scene></X3D>
      """;

  @TempDir private Path folder;

  @Test
  void afterTheIterationsItSaysThatItsLightIsThatOfTheLast() throws Exception {
    Path messages =
        cancelled("iteration  2", "--store", "vertices", "--rays", "100", "--max-mesh", "0.3");
    assertThat(folder.resolve("data")).content().contains("slab-lit.x3d", "cancelled");
    assertThat(folder.resolve("slab-lit.x3d")).isNotEmptyFile();
    assertThat(messages).content().doesNotContain("Exception");
  }

  @Test
  void soItDoesWhereTexelsAreLit() throws Exception {
    Path messages = cancelled("iteration  2", "--texels-per-metre", "10", "--rays", "100");
    assertThat(folder.resolve("data")).content().contains("slab-lit.x3d", "cancelled");
    assertThat(folder.resolve("slab-lit.x3d")).content().contains("slab-lit-light.png");
    assertThat(ImageIO.read(folder.resolve("slab-lit-light.png").toFile())).isNotNull();
    assertThat(messages).content().doesNotContain("Exception", "did not stop in time");
  }

  /** Cancels when the messages contain something, at which the work waits; returns them. */
  private Path cancelled(String seen, String... options) throws IOException, InterruptedException {
    Path scene = folder.resolve("slab.x3d");
    Files.writeString(scene, SLAB_UNDER_A_LAMP);
    Path messages = folder.resolve("messages");
    List<String> command =
        new ArrayList<>(
            List.of(
                ProcessHandle.current().info().command().orElse("java"),
                "-cp",
                System.getProperty("java.class.path"),
                PausingRadiosity.class.getName(),
                seen,
                scene.toString()));
    command.addAll(List.of(options));
    Process run =
        new ProcessBuilder(command)
            .redirectError(messages.toFile())
            .redirectOutput(folder.resolve("data").toFile())
            .start();
    try {
      assumeTrue(run.supportsNormalTermination(), "no signals");
      Eventually.await(
          seen,
          () -> {
            assertThat(run.isAlive()).as(Files.readString(messages)).isTrue();
            return Files.readString(messages).contains(seen);
          });
      run.destroy(); // SIGTERM.
      run.waitFor();
    } finally {
      run.destroyForcibly();
    }
    return messages;
  }
}
