package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.net.httpserver.HttpServer;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.selectiverenderer.authoring.DocumentSnapshot;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.HostPattern;
import org.selectiverenderer.x3d.url.HttpFetcher;

/** The picture goes on while files of new nodes are awaited. */
@ShowsWindows
class PatchLoadingTest {
  @TempDir Path folder;

  @Test
  void thePreviewDoesNotWaitForTheImageOfANewNode() throws Exception {
    CountDownLatch asked = new CountDownLatch(1);
    CountDownLatch pictureGoesOn = new CountDownLatch(1);
    AtomicBoolean meanwhile = new AtomicBoolean();
    HttpServer server =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.createContext(
        "/",
        exchange -> {
          asked.countDown();
          try {
            pictureGoesOn.await();
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
          exchange.sendResponseHeaders(404, -1);
          exchange.close();
        });
    server.start();
    String host = "127.0.0.1:" + server.getAddress().getPort();
    String text = "<X3D version='4.0'>\n<Scene><Group DEF='G'/></Scene></X3D>";
    SceneDocument document = SceneDocument.of("scene.x3d", text.getBytes(StandardCharsets.UTF_8));
    DocumentSnapshot before = document.snapshot();
    List<ChangedRange> changed = new ArrayList<>();
    document.addListener(change -> changed.add(ChangedRange.of(change)));
    document.type(
        text.indexOf("</Scene>"),
        text.indexOf("</Scene>"),
        "<Shape DEF='New'><Appearance><ImageTexture url='\"http://%s/slow.png\"'/></Appearance>"
                .formatted(host)
            + "<Box/></Shape>");
    ScenePatch patch =
        ChangedPart.of(document, changed.get(0), NodeCatalogue.load()).stream()
            .flatMap(
                part ->
                    SceneTextDiff.between(before, document.snapshot(), part, NodeCatalogue.load())
                        .stream())
            .findFirst()
            .orElseThrow();
    ContentAccessPolicy access =
        new ContentAccessPolicy(List.of(), new HttpFetcher(List.of(new HostPattern(host))));
    CountDownLatch taken = new CountDownLatch(1);
    AtomicBoolean refused = new AtomicBoolean();
    try (PreviewThread preview = new PreviewThread(new Silent())) {
      preview.show(LoadedPreview.of(before, folder, access));
      Thread loader = new Thread(() -> preview.patch(patch, () -> refused.set(true)), "loader");
      loader.start();
      assertThat(asked.await(60, TimeUnit.SECONDS)).as("the image is fetched").isTrue();
      preview.ask(
          stage -> {
            meanwhile.set(loader.isAlive()); // It waits for the image.
            pictureGoesOn.countDown();
          });
      loader.join(TimeUnit.MINUTES.toMillis(1));
      preview.ask(stage -> taken.countDown());
      assertThat(taken.await(60, TimeUnit.SECONDS)).isTrue();
      assertThat(meanwhile).as("the picture goes on meanwhile").isTrue();
      assertThat(refused).isFalse();
    } finally {
      pictureGoesOn.countDown();
      server.stop(0);
    }
  }

  private static final class Silent implements PreviewThread.Listener {
    @Override
    public void drawn(PreviewFrame frame) {
      // Nobody looks.
    }

    @Override
    public void failed(String sentence) {
      throw new AssertionError(sentence);
    }
  }
}
