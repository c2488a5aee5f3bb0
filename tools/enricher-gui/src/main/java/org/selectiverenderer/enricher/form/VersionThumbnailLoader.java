package org.selectiverenderer.enricher.form;

import java.awt.Dimension;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch.ChoiceNode;
import org.selectiverenderer.authoring.nodes.SceneExcerpt;
import org.selectiverenderer.enricher.preview.VersionImage;
import org.selectiverenderer.enricher.preview.VersionImageRenderer;
import org.selectiverenderer.enricher.preview.VersionImageSpec;
import org.selectiverenderer.enricher.preview.VersionSource;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.text.Remarks;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.url.ContentAccessPolicy;
import org.selectiverenderer.x3d.url.UrlResolver;

/**
 * Finds the model of one choice, the file that an Inline names or the choice's own text, and
 * requests its thumbnail.
 */
final class VersionThumbnailLoader {
  /**
   * Most characters of a version in the scene itself, as its text is copied; longer ones get no
   * picture.
   */
  private static final int LONGEST = 4_000_000;

  private final EnricherSession session;
  private final VersionImageRenderer pictures;
  private final Dimension pixels;
  private final Consumer<VersionImage> taken;
  private final Consumer<String> failed;
  private @Nullable BackgroundTask finding;
  private VersionImageRenderer.@Nullable Request request;

  /**
   * @param pixels size of the picture in device pixels
   * @param taken called with the picture and the number of polygons
   * @param failed called with the reason if there is none
   */
  VersionThumbnailLoader(
      EnricherSession session,
      VersionImageRenderer pictures,
      Dimension pixels,
      Consumer<VersionImage> taken,
      Consumer<String> failed) {
    this.session = session;
    this.pictures = pictures;
    this.pixels = pixels;
    this.taken = taken;
    this.failed = failed;
  }

  void begin(ChoiceNode choice) {
    Path scene = session.file().path();
    if (!choice.url().isEmpty()) {
      finding =
          session
              .tasks()
              .run(
                  Texts.of("form.finding", choice.url()),
                  () -> file(scene, choice.url(), session.access()),
                  file -> ask(new VersionSource.OfFile(file)),
                  e -> failed.accept(String.valueOf(e.getMessage())));
      return;
    }
    inScene(choice.element(), scene)
        .ifPresentOrElse(this::ask, () -> failed.accept(Texts.of("form.nopicture")));
  }

  private static Path file(Path scene, String url, ContentAccessPolicy access) throws IOException {
    Path folder = Optional.ofNullable(scene.toAbsolutePath().getParent()).orElse(scene);
    UrlResolver.Target target = new UrlResolver(folder, access).resolve(url, folder);
    if (target instanceof UrlResolver.Target.Refused refused) {
      throw new IOException(Texts.of("form.refused", Remarks.shown(refused.reason())));
    }
    return ((UrlResolver.Target.Found) target)
        .content()
        .file()
        .orElseThrow(() -> new IOException(Texts.of("form.nofile")));
  }

  /** Returns the choice as a scene of its own; empty for a very long text. */
  private Optional<VersionSource> inScene(DocumentElement element, Path scene) {
    SceneDocument document = session.document();
    if (element.end() - element.start() > LONGEST) {
      return Optional.empty();
    }
    Path folder = Optional.ofNullable(scene.toAbsolutePath().getParent()).orElse(scene);
    return SceneExcerpt.of(document, element)
        .filter(text -> text.length() <= LONGEST)
        .map(
            text ->
                new VersionSource.OfContent(
                    document.name(), text.getBytes(StandardCharsets.UTF_8), folder));
  }

  private void ask(VersionSource source) {
    request =
        pictures.request(
            source, VersionImageSpec.solid(pixels.width, pixels.height), taken, failed);
  }

  void cancel() {
    if (finding != null) {
      finding.cancel();
    }
    if (request != null) {
      request.cancel();
    }
  }
}
