package org.selectiverenderer.enricher.source;

import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.base.markup.MarkupEscaper;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentError;

/** The bar below the text that shows why it is not well formed, or why it is read-only. */
final class FaultBar {
  private final JLabel notice = new JLabel();
  private final JButton place = new JButton(Texts.of("source.show"));
  private final JPanel panel = new JPanel(new MigLayout("insets 6", "[grow][]"));

  /**
   * @param show scrolls to the fault
   */
  FaultBar(Runnable show) {
    notice.getAccessibleContext().setAccessibleName(Texts.of("source.state"));
    place.setName("showFault");
    place.addActionListener(event -> show.run());
    panel.add(notice, "growx, wmin 0");
    panel.add(place);
  }

  JPanel component() {
    return panel;
  }

  void show(SceneDocument document) {
    Optional<DocumentError> fault = document.fault();
    Optional<String> locked = document.locked();
    panel.setVisible(fault.isPresent() || locked.isPresent());
    place.setVisible(fault.isPresent());
    notice.setIcon(UIManager.getIcon("OptionPane.warningIcon"));
    if (fault.isPresent()) {
      int line = fault.get().location().line();
      String why = MarkupEscaper.text(fault.get().message());
      notice.setText("<html>" + Texts.of("source.fault", line, Integer.toString(line), why));
    } else {
      locked.ifPresent(
          why -> notice.setText("<html>" + Texts.of("source.locked", MarkupEscaper.text(why))));
    }
  }
}
