package org.selectiverenderer.enricher.form;

import java.awt.Font;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import javax.swing.ScrollPaneConstants;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.document.DocumentElement;
import org.selectiverenderer.document.DocumentListener;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.tree.NodeIcon;

/**
 * The right side of the window: the form of the selected node, or of the one that it is part of.
 */
public final class FormPanel {
  private final EnricherSession session;
  private final VersionImages images;
  private final FormBody body = new FormBody();
  private final JLabel title = new JLabel();
  private final JLabel hint = new JLabel();
  private final JScrollPane scroll = new JScrollPane(body);
  private final SelectionListener selecting = (element, origin) -> select(element);
  private final DocumentListener changing = change -> refresh();
  private @Nullable NodeForm form;
  private @Nullable DocumentElement shown;

  public FormPanel(EnricherSession session, VersionImages images) {
    this.session = session;
    this.images = images;
    title.setFont(title.getFont().deriveFont(Font.BOLD, title.getFont().getSize2D() * 1.2f));
    title.getAccessibleContext().setAccessibleName("Selected node");
    scroll.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    scroll.getVerticalScrollBar().getAccessibleContext().setAccessibleName("Scroll the form");
    scroll.getHorizontalScrollBar().getAccessibleContext().setAccessibleName("Scroll the form");
    session.addSelectionListener(selecting);
    session.document().addListener(changing);
    select(session.selection());
  }

  public JScrollPane component() {
    return scroll;
  }

  private void select(Optional<DocumentElement> element) {
    Optional<DocumentElement> node = element.flatMap(this::formed);
    if (form != null && node.isPresent() && node.get() == shown) {
      return;
    }
    build(node);
  }

  /** The Switch or sensor that an element is or stands in. */
  private Optional<DocumentElement> formed(DocumentElement element) {
    for (DocumentElement at = element; at != null; at = at.parent().orElse(null)) {
      if (at.attached()
          && (session.enrichment().switchNode(at).isPresent()
              || session.enrichment().sensorNode(at).isPresent())) {
        return Optional.of(at);
      }
    }
    return Optional.empty();
  }

  private void build(Optional<DocumentElement> node) {
    commit();
    if (form != null) {
      form.dispose();
      form = null;
    }
    body.removeAll();
    shown = node.orElse(null);
    title.setIcon(
        node.map(each -> new NodeIcon(NodeIcon.Kind.of(each.name()), NodeIcon.Mark.NONE))
            .orElse(null));
    body.add(title, "growx, wmin 0, wrap");
    body.add(hint, "growx, wmin 0, wrap");
    node.ifPresent(
        element -> {
          session
              .enrichment()
              .switchNode(element)
              .ifPresent(
                  each -> {
                    title.setText(each.object());
                    say(
                        "An object in %d versions. Say of each what holds for it."
                            .formatted(each.choices().size()));
                    form = new SwitchForm(session, each, images);
                  });
          session
              .enrichment()
              .sensorNode(element)
              .ifPresent(
                  each -> {
                    title.setText(each.name());
                    say(
                        "An area. Say which schemas become active when the viewer enters or leaves"
                            + " it; several are separated by commas.");
                    form = new SensorForm(session, each);
                  });
        });
    if (form == null) {
      title.setText("Nothing to fill in here");
      say("Choose a Switch (an object in versions) or a ProximitySensor (an area).");
    } else {
      body.add(form.component(), "growx, wmin 0");
    }
    body.revalidate();
    body.repaint();
  }

  private void say(String sentence) {
    hint.setText("<html>" + sentence);
  }

  private void refresh() {
    boolean there = shown != null && shown.attached() && form != null && form.refresh();
    if (!there) {
      if (form != null) {
        form.dispose();
        form = null; // its node is gone, and with it what was typed
      }
      build(session.selection().flatMap(this::formed));
    }
  }

  /** Takes over what is typed and not yet in the document. */
  public void commit() {
    if (form != null && shown != null && shown.attached()) {
      form.commit();
    }
  }

  /** Lets go of the session. */
  public void dispose() {
    if (form != null) {
      form.dispose();
    }
    session.removeSelectionListener(selecting);
    session.document().removeListener(changing);
  }
}
