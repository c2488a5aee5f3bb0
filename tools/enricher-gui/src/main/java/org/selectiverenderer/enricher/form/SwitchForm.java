package org.selectiverenderer.enricher.form;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSeparator;
import net.miginfocom.swing.MigLayout;
import org.selectiverenderer.authoring.enrichment.EnrichedSwitch;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.area.NodeCommands;
import org.selectiverenderer.enricher.preview.VersionImageRenderer;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Mnemonics;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The form of a Switch: its name, the choice shown at the start, and its choices one below the
 * other.
 */
final class SwitchForm implements Form {
  /** Choices shown per page; a button shows the next page. */
  private static final int PAGE = 20;

  private final EnricherSession session;
  private final VersionImageRenderer pictures;
  private final DocumentElement element;
  private final int size;
  private final NameFieldRow name;
  private final SwitchControls tools;
  private final List<ChoiceForm> choices = new ArrayList<>();
  private final JPanel panel =
      new JPanel(new MigLayout("insets 0, wrap 1, hidemode 3", "[grow,fill]")) {
        private static final long serialVersionUID = 1L;

        @Override
        public void addNotify() {
          super.addNotify();
          load();
        }
      };
  private final JPanel pages =
      new JPanel(new MigLayout("insets 0, wrap 1, hidemode 3", "[grow,fill]"));
  private final JButton more = new JButton();
  private final QualitiesForm qualities;

  SwitchForm(EnricherSession session, VersionImageRenderer pictures, EnrichedSwitch node) {
    this.session = session;
    this.pictures = pictures;
    this.element = node.element();
    this.size = node.choices().size();
    NodeCommands nodes = new NodeCommands(session);
    name = new NameFieldRow(session, nodes, element);
    tools = new SwitchControls(session, nodes, node);
    name.add("area.switch.unwrap", "area.switch.unwrap.tip", "Unwrap", event -> tools.unwrap());
    panel.add(name.component(), "wmin 0");
    panel.add(tools.component(), "wmin 0");
    if (size == 0) {
      panel.add(LabelFactory.sentences(Texts.of("area.switch.empty")), "wmin 0");
    }
    panel.add(
        LabelFactory.names("consistencyType", "degreeOfConsistency", "schemaBelonginess"),
        "wmin 0");

    panel.add(pages, "wmin 0");
    qualities = new QualitiesForm(session, node);
    panel.add(qualities.component(), "wmin 0");
    more.addActionListener(event -> node().ifPresent(this::page));
    page(node);
  }

  private Optional<EnrichedSwitch> node() {
    return session.enrichment().switchNode(element);
  }

  private void page(EnrichedSwitch node) {
    pages.remove(more);
    int end = Math.min(size, choices.size() + PAGE);
    for (int i = choices.size(); i < end; i++) {
      ChoiceForm choice =
          new ChoiceForm(session, pictures, node, node.choices().get(i), tools.buttons(i, size));
      choices.add(choice);
      pages.add(new JSeparator());
      pages.add(choice.component(), "wmin 0");
    }
    if (end < size) {
      Mnemonics.on(more, Texts.of("form.more", DecimalFormatter.grouped(size - end)));
      pages.add(more, "growx 0");
    }
    panel.revalidate();
    load();
  }

  private void load() {
    if (panel.isDisplayable()) {
      choices.forEach(ChoiceForm::load);
    }
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public boolean fits() {
    return node().filter(this::fits).isPresent();
  }

  private boolean fits(EnrichedSwitch node) {
    boolean same = node.choices().size() == size;
    for (int i = 0; same && i < choices.size(); i++) {
      same = choices.get(i).fits(node.choices().get(i));
    }
    return same;
  }

  @Override
  public void follow() {
    name.field().follow();
    tools.field().follow();
    node()
        .ifPresent(
            node -> {
              choices.forEach(choice -> choice.follow(node));
              qualities.follow(node);
            });
  }

  @Override
  public void commit() {
    name.field().commit();
    choices.forEach(ChoiceForm::commit);
    qualities.commit();
  }

  @Override
  public void dispose() {
    name.field().close();
    tools.field().close();
    choices.forEach(ChoiceForm::dispose);
    qualities.close();
  }
}
