package org.selectiverenderer.enricher.source;

import java.util.Locale;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.text.Texts;

/**
 * The bar that shows which part of a large text is shown, with buttons to the neighbouring parts.
 */
final class PageBar {
  private final JLabel words = new JLabel();
  private final JPanel panel = new JPanel(new MigLayout("insets 4 6 4 6", "[][][grow]"));

  PageBar(SourceAreaBinding page) {
    JButton earlier = new JButton(Texts.of("source.earlier"));
    JButton later = new JButton(Texts.of("source.later"));
    earlier.setName("earlierPart");
    later.setName("laterPart");
    earlier.addActionListener(
        event -> page.turn(Math.max(0, page.shown().from() - VisibleSourceRange.PAGE / 2)));
    later.addActionListener(event -> page.turn(page.shown().to() + VisibleSourceRange.PAGE / 4));
    panel.add(earlier);
    panel.add(later);
    panel.add(words, "growx, wmin 0");
  }

  JPanel component() {
    return panel;
  }

  /**
   * Shows the position of a part in a text of some length; hides the bar if the part is the whole
   * text.
   */
  void show(VisibleSourceRange page, int all) {
    panel.setVisible(page.length() < all);
    words.setText(Texts.of("source.part", number(page.from()), number(page.to()), number(all)));
  }

  private static String number(int characters) {
    return String.format(Locale.ROOT, "%,d", characters);
  }
}
