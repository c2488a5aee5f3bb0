package org.selectiverenderer.enricher.form;

import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.ElementFinding;
import org.selectiverenderer.authoring.enrichment.EnrichedSensor;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.problems.SeverityIcon;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Lists the findings about the selected node, each with a button that fixes it where a fix is
 * known. Its height is constant, so that no field moves under the mouse.
 */
final class FindingsPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  /**
   * Height in lines: the count and two findings with their buttons; further ones are scrolled to.
   */
  private static final int LINES = 9;

  /** Height in lines where there is little room: the count and one finding. */
  private static final int LEAST = 4;

  /** The part of the form's height that this takes at most. */
  private static final double SHARE = 0.25;

  private final transient EnricherSession session;
  private final JLabel title = new JLabel();
  private final JPanel list =
      new ScrollablePanel(new MigLayout("insets 0, wrap 2, hidemode 3", "[][grow,fill]"));
  private transient List<ElementFinding> shown = List.of();
  private transient Function<DocumentElement, List<ElementFinding>> problems = element -> List.of();

  FindingsPanel(EnricherSession session) {
    super(new MigLayout("insets 4 8 4 8, wrap 1, gapy 2", "[grow,fill]", "[][grow,fill]"));
    this.session = session;
    getAccessibleContext().setAccessibleName(Texts.of("keep.findings"));
    title.setName("Findings");
    add(title, "wmin 0");
    JScrollPane scroll = new JScrollPane(list);
    scroll.setBorder(null);
    scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
    scroll.getVerticalScrollBar().setUnitIncrement(16);
    scroll
        .getVerticalScrollBar()
        .getAccessibleContext()
        .setAccessibleName(Texts.of("keep.findings.scroll"));
    add(scroll, "wmin 0, hmin 0");
    setBorder(
        BorderFactory.createMatteBorder(1, 0, 0, 0, UIManager.getColor("Separator.foreground")));
    head();
  }

  @Override
  public Dimension getPreferredSize() {
    int line = title.getFontMetrics(title.getFont()).getHeight();
    int room = getParent() == null ? 0 : (int) (SHARE * getParent().getHeight() / line);
    return new Dimension(0, line * (room == 0 ? LINES : Math.max(LEAST, Math.min(LINES, room))));
  }

  @Override
  public Dimension getMinimumSize() {
    return getPreferredSize();
  }

  private void head() {
    title.setText(
        shown.isEmpty()
            ? Texts.of("keep.findings.none")
            : Texts.of("keep.findings.some", shown.size(), DecimalFormatter.grouped(shown.size())));
    title.setEnabled(!shown.isEmpty());
  }

  /** Sets what knows the problems of an element that a check in the background has found. */
  void problems(Function<DocumentElement, List<ElementFinding>> known) {
    problems = known;
  }

  /** Shows the findings about an element. */
  void show(Optional<DocumentElement> element) {
    List<ElementFinding> now = element.map(this::findings).orElse(List.of());
    if (same(now)) {
      shown = now;
      return;
    }
    shown = now;
    head();
    list.removeAll();
    for (int i = 0; i < now.size(); i++) {
      add(now.get(i), i);
    }
    list.revalidate();
    list.repaint();
  }

  private List<ElementFinding> findings(DocumentElement element) {
    List<ElementFinding> about = new ArrayList<>(own(element));
    for (ElementFinding problem : problems.apply(element)) {
      int at = 0;
      while (at < about.size() && !tellsOf(problem, about.get(at))) {
        at++;
      }
      if (at < about.size()) {
        about.set(at, problem); // with the severity that the list of problems gives it
      } else {
        about.add(problem);
      }
    }
    return about;
  }

  /** Whether a problem is a finding that is known at once, found again by the validator. */
  private static boolean tellsOf(ElementFinding problem, ElementFinding known) {
    return problem.element() == known.element() && problem.message().startsWith(known.message());
  }

  private List<ElementFinding> own(DocumentElement element) {
    List<ElementFinding> own =
        session
            .enrichment()
            .switchNode(element)
            .map(EnrichedSwitch::findings)
            .or(() -> session.enrichment().sensorNode(element).map(EnrichedSensor::findings))
            .orElse(List.of());
    return session.enrichment().findings().stream()
        .filter(finding -> finding.element() == element || own.contains(finding))
        .toList();
  }

  private boolean same(List<ElementFinding> now) {
    boolean same = now.size() == shown.size();
    for (int i = 0; same && i < now.size(); i++) {
      same =
          now.get(i).message().equals(shown.get(i).message())
              && now.get(i).severity() == shown.get(i).severity()
              && now.get(i).element() == shown.get(i).element();
    }
    return same;
  }

  private void add(ElementFinding finding, int index) {
    list.add(SeverityIcon.label(finding.severity()), "aligny top");
    list.add(LabelFactory.sentences(finding.message()), "wmin 0");
    finding
        .fix()
        .ifPresent(
            fix -> {
              JButton mend = new JButton(PlainText.of(fix.name()));
              mend.setName("Fix " + index);
              if (index == 0) {
                mend.setMnemonic('X');
              }
              mend.addActionListener(event -> mend(index));
              list.add(mend, "skip 1, growx 0, wmin 0");
            });
  }

  /** Applies the fix of the present finding at an index, as earlier ones refer to an older text. */
  private void mend(int index) {
    shown
        .get(index)
        .fix()
        .ifPresent(fix -> session.attempt(() -> session.perform(fix.edit().get())));
  }
}
