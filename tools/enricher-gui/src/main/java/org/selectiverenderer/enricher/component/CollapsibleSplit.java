package org.selectiverenderer.enricher.component;

import java.awt.BorderLayout;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import javax.swing.UIManager;

/**
 * A view with another one below it, which can be folded away: then a line with its title is left of
 * it, and the upper view has all the room.
 */
public final class CollapsibleSplit extends JPanel {
  private static final long serialVersionUID = 1L;

  private final JComponent upper;
  private final JSplitPane split;
  private final JPanel lower = new JPanel(new BorderLayout());
  private final JToggleButton header = new JToggleButton();

  /**
   * @param split the split pane of both views, one above the other
   * @param title of the lower view
   * @param help what a click on the title does
   * @param chosen called when the author opens (true) or folds away the lower view
   */
  public CollapsibleSplit(JSplitPane split, String title, String help, Consumer<Boolean> chosen) {
    super(new BorderLayout());
    this.split = split;
    upper = (JComponent) split.getTopComponent();
    lower.add(split.getBottomComponent(), BorderLayout.CENTER);
    split.setBottomComponent(lower);
    header.setText(title);
    header.setToolTipText(help);
    header.setHorizontalAlignment(SwingConstants.LEADING);
    header.putClientProperty("JButton.buttonType", "borderless");
    header.addActionListener(
        event -> {
          open(header.isSelected());
          chosen.accept(header.isSelected());
        });
    open(false);
  }

  /** Shows the lower view, or folds it away. */
  public void open(boolean open) {
    header.setSelected(open);
    header.setIcon(UIManager.getIcon(open ? "Tree.expandedIcon" : "Tree.collapsedIcon"));
    removeAll();
    if (open) {
      lower.add(header, BorderLayout.NORTH);
      split.setTopComponent(upper);
      add(split, BorderLayout.CENTER);
    } else {
      add(upper, BorderLayout.CENTER);
      add(header, BorderLayout.SOUTH);
    }
    revalidate();
    repaint();
  }

  /** Whether the lower view is shown. */
  public boolean open() {
    return header.isSelected();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (header != null) { // the superclass's constructor calls this
      header.setIcon(UIManager.getIcon(open() ? "Tree.expandedIcon" : "Tree.collapsedIcon"));
    }
  }
}
