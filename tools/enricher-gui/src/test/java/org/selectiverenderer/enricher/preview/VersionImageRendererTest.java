package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.testing.RequiresDisplay;

@RequiresDisplay
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class VersionImageRendererTest {
  private static final int PAPER = 0xd1d1d1;

  private final LinkedBlockingQueue<Object> answers = new LinkedBlockingQueue<>();
  @TempDir Path folder;

  private static String model(String geometry) {
    return "<X3D profile='Immersive' version='4.0'><Scene><Shape><Appearance>"
        + "<UnlitMaterial emissiveColor='0 0 1'/></Appearance>"
        + geometry
        + "</Shape></Scene></X3D>";
  }

  private Object ask(VersionImageRenderer pictures, VersionSource source, VersionImageSpec look)
      throws InterruptedException {
    EventThread.edt(() -> pictures.request(source, look, answers::add, answers::add));
    Object answer = answers.poll(60, TimeUnit.SECONDS);
    assertThat(answer).isNotNull();
    return answer;
  }

  private static double share(VersionImage picture) {
    BufferedImage image = picture.image();
    int other = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        other += (image.getRGB(x, y) & 0xffffff) == PAPER ? 0 : 1;
      }
    }
    return other / (double) (image.getWidth() * image.getHeight());
  }

  @Test
  void aVersionFillsItsPictureSolidAndAsWireframe() throws Exception {
    Path file = Files.writeString(folder.resolve("box.x3d"), model("<Box size='200 200 200'/>"));
    try (VersionImageRenderer pictures = new VersionImageRenderer()) {
      VersionSource source = new VersionSource.OfFile(file);
      VersionImage solid = (VersionImage) ask(pictures, source, VersionImageSpec.solid(96, 72));
      VersionImage edges = (VersionImage) ask(pictures, source, VersionImageSpec.wireframe(96, 72));
      assertThat(solid.image().getWidth()).isEqualTo(96);
      assertThat(solid.image().getHeight()).isEqualTo(72);
      assertThat(solid.polygons()).isEqualTo(12);
      assertThat(share(solid)).isBetween(0.2, 0.8);
      assertThat(share(edges)).isGreaterThan(0.02).isLessThan(share(solid) * 0.7);
    }
  }

  @Test
  void aFileThatChangesIsSeenAnewAndOneThatDoesNotIsKept() throws Exception {
    Path file = Files.writeString(folder.resolve("box.x3d"), model("<Box/>"));
    try (VersionImageRenderer pictures = new VersionImageRenderer()) {
      VersionSource source = new VersionSource.OfFile(file);
      Object first = ask(pictures, source, VersionImageSpec.solid(96, 72));
      assertThat(ask(pictures, source, VersionImageSpec.solid(96, 72))).isSameAs(first);
      Files.writeString(file, model("<Sphere radius='2'/>"));
      VersionImage changed = (VersionImage) ask(pictures, source, VersionImageSpec.solid(96, 72));
      assertThat(changed.polygons()).isGreaterThan(12);
    }
  }

  @Test
  void contentWithoutAFileIsShownAndAMissingFileIsSaidSo() throws Exception {
    try (VersionImageRenderer pictures = new VersionImageRenderer()) {
      VersionSource planned =
          new VersionSource.OfContent(
              "planned.x3d", model("<Box/>").getBytes(StandardCharsets.UTF_8), folder);
      assertThat(ask(pictures, planned, VersionImageSpec.solid(200, 150)))
          .isInstanceOfSatisfying(
              VersionImage.class, picture -> assertThat(picture.polygons()).isEqualTo(12));
      VersionSource gone = new VersionSource.OfFile(folder.resolve("gone.x3d"));
      assertThat(ask(pictures, gone, VersionImageSpec.solid(96, 72)))
          .asString()
          .contains("gone.x3d");
    }
  }

  @Test
  void whatIsCancelledIsNotAnswered() throws Exception {
    try (VersionImageRenderer pictures = new VersionImageRenderer()) {
      VersionSource gone = new VersionSource.OfFile(folder.resolve("cancelled.x3d"));
      VersionSource other = new VersionSource.OfFile(folder.resolve("asked.x3d"));
      EventThread.edt(
          () ->
              pictures
                  .request(gone, VersionImageSpec.solid(96, 72), answers::add, answers::add)
                  .cancel());
      assertThat(ask(pictures, other, VersionImageSpec.solid(96, 72)))
          .asString()
          .contains("asked.x3d");
    }
  }
}
