package org.selectiverenderer.enricher.help;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import java.util.Optional;
import javax.swing.JEditorPane;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.validation.Rule;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The context-sensitive help: first the topic of the control with the focus, or else of the
 * selected node, then the workflow and all terms.
 *
 * <p>For the event dispatch thread.
 */
public final class HelpPanel extends JPanel {
  private static final long serialVersionUID = 1L;
  private static final String FOCUS = "permanentFocusOwner";

  private final transient EnricherSession session;
  private final transient SelectionListener onSelection = (element, origin) -> show(topic(element));
  private final transient PropertyChangeListener onFocus = this::focused;
  private final JEditorPane page = new JEditorPane("text/html", "");
  private @Nullable HelpTopic shown;

  public HelpPanel(EnricherSession session) {
    super(new MigLayout("insets 0", "[grow,fill]", "[grow,fill]"));
    this.session = session;
    page.putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, true);
    page.setEditable(false);
    page.getAccessibleContext().setAccessibleName(Texts.of("help.panel"));
    JScrollPane scroll = new JScrollPane(page);
    scroll.setBorder(null);
    scroll.getVerticalScrollBar().getAccessibleContext().setAccessibleName(Texts.of("help.scroll"));
    scroll
        .getHorizontalScrollBar()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("help.scroll"));
    add(scroll, "wmin 0, hmin 0");
    getAccessibleContext().setAccessibleName(Texts.of("help.panel"));
    write(Optional.empty());
    session.addSelectionListener(onSelection);
    KeyboardFocusManager.getCurrentKeyboardFocusManager().addPropertyChangeListener(FOCUS, onFocus);
    show(topic(session.selection()));
  }

  private static Optional<HelpTopic> topic(Optional<DocumentElement> element) {
    return element.flatMap(
        node ->
            switch (node.name()) {
              case "Switch" -> Optional.of(HelpTopic.SWITCH);
              case "ProximitySensor" -> Optional.of(HelpTopic.SENSOR);
              default -> Optional.empty();
            });
  }

  private void focused(PropertyChangeEvent event) {
    if (event.getNewValue() instanceof Component owner && mine(owner)) {
      HelpTopic.of(owner)
          .ifPresentOrElse(
              topic -> show(Optional.of(topic)), () -> show(topic(session.selection())));
    }
  }

  /**
   * Returns whether a component that gets the focus changes the topic: one of this window, but not
   * of the help itself, so that it can be read.
   */
  private boolean mine(Component owner) {
    Window window = SwingUtilities.getWindowAncestor(this);
    return window != null
        && window == SwingUtilities.getWindowAncestor(owner)
        && !SwingUtilities.isDescendingFrom(owner, this);
  }

  private void show(Optional<HelpTopic> topic) {
    if (topic.orElse(null) != shown) {
      write(topic);
    }
  }

  /** Shows the explanation of a validator rule, until the focus or the selection changes. */
  public void explain(Rule rule) {
    shown = null;
    page.setText(HelpPageBuilder.rule(rule));
    page.setCaretPosition(0);
  }

  private void write(Optional<HelpTopic> topic) {
    shown = topic.orElse(null);
    page.setText(HelpPageBuilder.page(topic));
    page.setCaretPosition(0);
  }

  /** Stops following selection and focus. */
  public void dispose() {
    session.removeSelectionListener(onSelection);
    KeyboardFocusManager.getCurrentKeyboardFocusManager()
        .removePropertyChangeListener(FOCUS, onFocus);
  }
}
