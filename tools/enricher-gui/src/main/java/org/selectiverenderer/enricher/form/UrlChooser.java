package org.selectiverenderer.enricher.form;

import java.nio.file.Path;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JFileChooser;
import org.selectiverenderer.enricher.component.FileUrl;
import org.selectiverenderer.enricher.component.NamedFileChooser;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.write.FieldValueFormatter;

/** The button in a field of urls that chooses a file, which the scene then names. */
final class UrlChooser extends JButton {
  private static final long serialVersionUID = 1L;

  /**
   * @param chosen called with the url as an X3D string
   */
  UrlChooser(EnricherSession session, String field, Consumer<String> chosen) {
    super("\u2026");
    setName("file of " + field);
    setToolTipText(Texts.of("fields.file"));
    getAccessibleContext().setAccessibleName(Texts.of("fields.file"));
    addActionListener(
        event -> {
          Path scene = session.file().path();
          Path folder = scene.toAbsolutePath().getParent();
          NamedFileChooser files = new NamedFileChooser();
          files.setCurrentDirectory(folder == null ? null : folder.toFile());
          files.setDialogTitle(Texts.of("fields.file"));
          if (files.showOpenDialog(this) == JFileChooser.APPROVE_OPTION) {
            chosen.accept(FieldValueFormatter.strings(FileUrl.of(scene, files.chosen())));
          }
        });
  }
}
