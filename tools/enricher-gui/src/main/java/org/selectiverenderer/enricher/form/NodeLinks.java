package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/** The nodes that a field holds: a button for each, which selects it in the tree. */
final class NodeLinks extends JPanel {
  private static final long serialVersionUID = 1L;

  /** Most nodes that have a button; the tree has all. */
  private static final int SHOWN = 20;

  private final transient EnricherSession session;
  private transient List<DocumentElement> nodes = List.of();
  private String shown = "";

  NodeLinks(EnricherSession session) {
    super(new MigLayout("insets 0, gap 0, wrap 1", "[grow,fill]"));
    this.session = session;
    setOpaque(false);
  }

  /**
   * Shows nodes.
   *
   * @param none the text in place of no nodes
   */
  void show(List<DocumentElement> now, String none) {
    String texts = now.stream().limit(SHOWN).map(NodeLinks::text).collect(Collectors.joining("\n"));
    String said = now.isEmpty() ? none : now.size() + "\n" + texts;
    if (said.equals(shown) && now.equals(nodes)) {
      return;
    }
    shown = said;
    nodes = List.copyOf(now);
    removeAll();
    nodes.stream().limit(SHOWN).forEach(node -> add(link(node), "wmin 0"));
    if (nodes.isEmpty()) {
      add(new JLabel(none), "wmin 0");
    } else if (nodes.size() > SHOWN) {
      int more = nodes.size() - SHOWN;
      add(new JLabel(Texts.of("fields.moreNodes", more, Integer.toString(more))), "wmin 0");
    }
    revalidate();
    repaint();
  }

  private JButton link(DocumentElement node) {
    JButton button = PlainText.only(new JButton(text(node)));
    button.setHorizontalAlignment(SwingConstants.LEADING);
    button.setToolTipText(Texts.of("fields.select"));
    button.getAccessibleContext().setAccessibleDescription(button.getToolTipText());
    button.addActionListener(event -> session.select(node, this));
    return button;
  }

  private static String text(DocumentElement node) {
    return node.use().map(name -> node.name() + " " + name).orElse(node.toString());
  }
}
