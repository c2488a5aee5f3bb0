package org.selectiverenderer.enricher.form;

import com.formdev.flatlaf.util.UIScale;
import java.nio.file.Path;
import java.util.List;
import javax.swing.ImageIcon;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.images.ImageReference;
import org.selectiverenderer.enricher.images.ByteFormat;
import org.selectiverenderer.enricher.images.InspectedImage;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.task.BackgroundTask;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.url.UrlResolver;

/** The part of a texture's form that shows its image, its pixels and its bytes. */
final class TextureForm implements Form {
  private static final int SIDE = 128;

  private final EnricherSession session;
  private final DocumentElement element;
  private final JPanel panel = new JPanel(new MigLayout("insets 0, wrap 1, hidemode 3", "[grow]"));
  private final JLabel picture = new JLabel();
  private final JLabel facts = PlainText.only(new JLabel(" "));
  private List<String> urls = List.of();
  private @Nullable BackgroundTask reading;

  TextureForm(EnricherSession session, DocumentElement element) {
    this.session = session;
    this.element = element;
    picture.setName("texture image");
    picture.getAccessibleContext().setAccessibleName(Texts.of("images.picture"));
    facts.setName("texture facts");
    panel.add(picture);
    panel.add(facts, "wmin 0");
    follow();
  }

  /** Returns whether an element names one image. */
  static boolean shows(DocumentElement element) {
    return element.name().equals("ImageTexture");
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public boolean fits() {
    return true;
  }

  @Override
  public void follow() {
    DocumentElement texture =
        element
            .use()
            .flatMap(name -> session.document().tree().flatMap(tree -> tree.named(name, element)))
            .orElse(element);
    List<String> now =
        ImageReference.of(texture).stream().findFirst().map(ImageReference::urls).orElse(List.of());
    if (now.equals(urls)) {
      return;
    }
    urls = now;
    dispose();
    Path folder = session.file().path().toAbsolutePath().resolveSibling("");
    int side = UIScale.scale(SIDE);
    facts.setText(Texts.of("images.reading"));
    reading =
        session
            .tasks()
            .run(
                Texts.of("images.reading"),
                () ->
                    InspectedImage.of(now, new UrlResolver(folder, session.access()), folder, side),
                this::show,
                failure -> facts.setText(String.valueOf(failure.getMessage())));
  }

  private void show(InspectedImage image) {
    reading = null;
    picture.setIcon(image.thumbnail().map(ImageIcon::new).orElse(null));
    facts.setText(
        image.readable()
            ? Texts.of(
                "images.facts",
                String.valueOf(image.width()),
                String.valueOf(image.height()),
                ByteFormat.of(image.bytes()),
                ByteFormat.of(image.cardBytes()))
            : image.fault());
    facts.setToolTipText(facts.getText());
    panel.revalidate();
  }

  @Override
  public void commit() {
    // nothing is typed here
  }

  @Override
  public void dispose() {
    if (reading != null) {
      reading.cancel();
      reading = null;
    }
  }
}
