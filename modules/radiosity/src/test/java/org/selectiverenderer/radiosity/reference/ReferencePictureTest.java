package org.selectiverenderer.radiosity.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.selectiverenderer.radiosity.TestScenes.room;

import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.ForkJoinPool;
import org.joml.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.radiosity.TestScenes;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/** Sums of passes: the same however they were come by. */
class ReferencePictureTest {
  private static final ReferenceScene.View VIEW =
      new ReferenceScene.View("", "", new Matrix4d().translation(2, 2, 3.5), 1);

  @TempDir private Path folder;

  private static RadiosityScene scene() throws Exception {
    return TestScenes.read(
        room(0, 0, 0, 4, "diffuseColor='0.7 0.5 0.3'") + "<PointLight location='2 3 1'/>");
  }

  private static ReferenceImage picture(RadiosityScene scene, int seed) {
    return new ReferenceImage(scene, PrimaryHits.of(scene, VIEW, 6, 4, 2), seed);
  }

  @Test
  void whatIsGoneOnWithIsWhatWouldHaveBeen() throws Exception {
    RadiosityScene scene = scene();
    ReferenceImage straight = picture(scene, 1);
    straight.pass();
    straight.pass();
    straight.pass();
    ReferenceImage begun = picture(scene, 1);
    begun.pass();
    begun.save(folder.resolve("sums"));
    ReferenceImage later = picture(scene, 1);
    later.load(folder.resolve("sums"));
    later.pass();
    later.pass();
    assertThat(later.samples()).isEqualTo(straight.samples()).isEqualTo(3 * 16 * 4);
    assertThat(later.light()).isEqualTo(straight.light());
  }

  @Test
  void oneProcessorGivesTheSameSumsAsMany() throws Exception {
    RadiosityScene scene = scene();
    ReferenceImage many = picture(scene, 1);
    many.pass();
    ReferenceImage one = picture(scene, 1);
    ForkJoinPool pool = new ForkJoinPool(1);
    try {
      pool.submit(one::pass).get();
    } finally {
      pool.shutdown();
    }
    assertThat(one.light()).isEqualTo(many.light());
  }

  @Test
  void sumsOfAnotherSeedAreRefused() throws Exception {
    RadiosityScene scene = scene();
    ReferenceImage one = picture(scene, 1);
    one.pass();
    Path sums = folder.resolve("sums");
    one.save(sums);
    assertThatThrownBy(() -> picture(scene, 2).load(sums))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("delete the file to begin anew");
  }
}
