package org.selectiverenderer.enricher.placement;

import java.awt.Dimension;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The path of names from the scene to the node selected last; a click on a name selects that node.
 */
public final class SelectionPath extends JPanel {
  private static final long serialVersionUID = 1L;

  /** The most names shown, counted from the innermost. */
  private static final int MOST = 6;

  /** The most characters of a name. */
  private static final int LONGEST = 24;

  private final transient EnricherSession session;
  private final transient SelectionListener onSelection = (element, origin) -> follow();
  private final transient DocumentListener onChange = change -> follow();
  private transient List<String> shown = List.of();

  /** Creates the path of a session's selection. */
  public SelectionPath(EnricherSession session) {
    super(new MigLayout("insets 0 4 0 4, gap 0"));
    this.session = session;
    setName("Selection path");
    getAccessibleContext().setAccessibleName(Texts.of("placement.path"));
    session.addSelectionListener(onSelection);
    session.document().addListener(onChange);
    follow();
  }

  private void follow() {
    List<DocumentElement> path =
        session
            .selection()
            .filter(DocumentElement::attached)
            .map(PlacementCommands::path)
            .orElse(List.of());
    List<String> names = path.stream().map(SelectionPath::name).toList();
    if (names.equals(shown) && getComponentCount() > 0) {
      return;
    }
    shown = names;
    removeAll();
    int from = Math.max(0, path.size() - MOST);
    if (from > 0) {
      add(new JLabel("\u2026 \u203a "));
    }
    for (int i = from; i < path.size(); i++) {
      if (i > from) {
        add(new JLabel("\u203a"));
      }
      add(button(names.get(i), path.size() - 1 - i), "wmin 0");
    }
    if (path.isEmpty()) {
      JLabel none = new JLabel(Texts.of("placement.path.none"));
      none.setEnabled(false);
      add(none, "wmin 0");
    }
    int count = session.selectedElements().size();
    if (count > 1) {
      add(new JLabel(Texts.of("placement.path.count", String.valueOf(count))), "gapleft 8, wmin 0");
    }
    revalidate();
    repaint();
  }

  private static String name(DocumentElement element) {
    String name = element.def().or(element::use).orElse(element.name());
    return name.length() > LONGEST ? name.substring(0, LONGEST - 1) + "\u2026" : name;
  }

  /**
   * @param up how many nodes the node is above the selected one
   */
  private JButton button(String name, int up) {
    JButton button = PlainText.only(new JButton(name));
    button.setName("path " + up);
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.setFocusable(true);
    button.setToolTipText(PlainText.of(Texts.of("placement.path.tip", name)));
    button.getAccessibleContext().setAccessibleName(name);
    button.addActionListener(
        event ->
            session
                .selection()
                .filter(DocumentElement::attached)
                .map(PlacementCommands::path)
                .filter(path -> path.size() > up)
                .ifPresent(path -> session.select(path.get(path.size() - 1 - up), this)));
    return button;
  }

  @Override
  public Dimension getPreferredSize() {
    Dimension size = super.getPreferredSize();
    int line = new JButton(Texts.of("placement.path")).getPreferredSize().height;
    return new Dimension(size.width, Math.max(size.height, line));
  }

  /** Stops following the session. */
  public void dispose() {
    session.removeSelectionListener(onSelection);
    session.document().removeListener(onChange);
  }
}
