package org.selectiverenderer.enricher;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.function.Consumer;
import org.selectiverenderer.document.enrichment.SwitchNode;
import org.selectiverenderer.enricher.form.VersionImages;
import org.selectiverenderer.enricher.preview.VersionLook;
import org.selectiverenderer.enricher.preview.VersionPictures;
import org.selectiverenderer.enricher.preview.VersionSource;
import org.selectiverenderer.enricher.session.EnricherSession;

/** Pictures of a scene's versions, whether they are files or stand in the scene itself. */
final class SceneVersionImages implements VersionImages {
  private static final int WIDTH = 104;
  private static final int HEIGHT = 78;

  private final EnricherSession session;
  private final VersionPictures pictures;

  SceneVersionImages(EnricherSession session, VersionPictures pictures) {
    this.session = session;
    this.pictures = pictures;
  }

  @Override
  public Runnable request(
      SwitchNode node,
      SwitchNode.ChoiceNode choice,
      Consumer<Look> taken,
      Consumer<String> failed) {
    VersionPictures.Request request =
        pictures.request(
            source(choice),
            VersionLook.solid(WIDTH, HEIGHT),
            picture -> taken.accept(new Look(picture.image(), picture.polygons())),
            failed);
    return request::cancel;
  }

  private VersionSource source(SwitchNode.ChoiceNode choice) {
    Path scene = session.file().path().toAbsolutePath();
    Path folder = scene.getParent() == null ? scene : scene.getParent();
    if (!choice.url().isEmpty()) {
      try {
        Path file = folder.resolve(choice.url());
        if (Files.isRegularFile(file)) {
          return new VersionSource.OfFile(file);
        }
      } catch (InvalidPathException e) {
        return inScene(choice, folder); // an address that is no file, such as one of the web
      }
    }
    return inScene(choice, folder);
  }

  private VersionSource inScene(SwitchNode.ChoiceNode choice, Path folder) {
    String text =
        "<X3D version='4.0'><Scene>" + session.document().text(choice.element()) + "</Scene></X3D>";
    return new VersionSource.OfContent(
        session.file().path().toString(), text.getBytes(StandardCharsets.UTF_8), folder);
  }
}
