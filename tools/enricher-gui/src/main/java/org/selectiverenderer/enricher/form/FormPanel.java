package org.selectiverenderer.enricher.form;

import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.authoring.DocumentListener;
import org.selectiverenderer.enricher.help.HelpTopic;
import org.selectiverenderer.enricher.preview.VersionImageRenderer;
import org.selectiverenderer.enricher.problems.ProblemsPanel;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.session.SelectionListener;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.swing.PlainText;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The panel with the form of the selected node (thesis Figs 44, 46): a Switch with a row for each
 * choice, a ProximitySensor with its schemas, and for other elements a summary with what can be
 * done. Each change is one edit of the document; the form follows the document and the selection.
 *
 * <p>For the event dispatch thread.
 */
public final class FormPanel extends JPanel {
  private static final long serialVersionUID = 1L;

  private final transient EnricherSession session;
  private final transient VersionImageRenderer pictures;
  private final transient SelectionListener onSelection = (element, origin) -> selected();
  private final transient DocumentListener onChange = change -> changed();
  private transient Consumer<DocumentElement> makeVersions = element -> {};
  private final transient FieldsForm.Choice allFields = new FieldsForm.Choice();
  private final transient PlacementForm.Keyboard keyboard = new PlacementForm.Keyboard();
  private final JPanel body =
      new ScrollablePanel(new MigLayout("insets 8, wrap 1, hidemode 3", "[grow,fill]"));
  private final JLabel title = PlainText.only(new JLabel());
  private final JLabel place = new JLabel();
  private final FindingsPanel findings;
  private transient @Nullable DocumentElement element;
  private transient @Nullable Form form;

  /** What is shown in place of a form; empty while there is one. */
  private String hinted = "";

  /**
   * @param pictures renders the thumbnails of versions; owned and closed by the caller
   */
  public FormPanel(EnricherSession session, VersionImageRenderer pictures) {
    super(new MigLayout("insets 0, wrap 1, hidemode 3, gapy 0", "[grow,fill]", "[grow,fill][]"));
    this.session = session;
    this.pictures = pictures;
    this.findings = new FindingsPanel(session);
    title.putClientProperty("FlatLaf.styleClass", "h3");
    title.getAccessibleContext().setAccessibleDescription(Texts.of("form.node"));
    place.getAccessibleContext().setAccessibleDescription(Texts.of("form.position"));
    place.setEnabled(false);
    JScrollPane scroll = new JScrollPane(body);
    scroll.setBorder(null);
    scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
    scroll.getVerticalScrollBar().setUnitIncrement(16);
    scroll.getVerticalScrollBar().getAccessibleContext().setAccessibleName(Texts.of("form.scroll"));
    add(scroll, "wmin 0, hmin 0");
    add(findings, "wmin 0");
    getAccessibleContext().setAccessibleName(Texts.of("form.panel"));
    session.addSelectionListener(onSelection);
    session.document().addListener(onChange);
    rebuild();
  }

  /** Sets what opens the versions dialog for an element. */
  public void onMakeVersions(Consumer<DocumentElement> action) {
    makeVersions = action;
  }

  /** Shows below the form what checks in the background find about the selected node, too. */
  public void follow(ProblemsPanel problems) {
    findings.problems(problems::about);
    problems.onEntries(() -> findings.show(Optional.ofNullable(element)));
  }

  /** Writes what has been typed so far; called before saving and undoing. */
  public void commit() {
    if (form != null) {
      form.commit();
    }
  }

  private void selected() {
    if (session.selection().orElse(null) != element) {
      commit();
      rebuild();
    } else if (form != null && form.fits()) {
      form.follow(); // others may be selected besides
    }
  }

  private void changed() {
    if (element == null && session.selection().isEmpty() && hint().equals(hinted)) {
      return; // as it is after most edits of a text in which nothing is selected
    }
    if (session.selection().orElse(null) != element || form == null || !form.fits()) {
      rebuild();
      return;
    }
    form.follow();
    head();
  }

  private void rebuild() {
    hinted = "";
    if (form != null) {
      Form old = form;
      form = null; // Its controls lose the focus now and must not write any more.
      old.dispose();
    }
    element = session.selection().orElse(null);
    body.removeAll();
    body.add(title, "wmin 0");
    body.add(place, "wmin 0");
    if (element != null) {
      Form made = CompositeForm.of(parts(element));
      form = made;
      body.add(made.component(), "wmin 0");
    } else {
      hinted = hint();
      body.add(LabelFactory.sentences(hinted), "wmin 0");
    }
    findings.setVisible(described());
    head();
    body.scrollRectToVisible(new Rectangle(0, 0, 1, 1));
    body.revalidate();
    body.repaint();
  }

  /** Whether the selected node is a Switch or sensor, which findings are about. */
  private boolean described() {
    return element != null
        && (session.enrichment().switchNode(element).isPresent()
            || session.enrichment().sensorNode(element).isPresent());
  }

  private String hint() {
    return session
        .document()
        .fault()
        .map(
            fault ->
                Texts.of(
                    "form.fault",
                    fault.location().line(),
                    Integer.toString(fault.location().line()),
                    fault.message()))
        .orElse(Texts.of("form.choose"));
  }

  /** Returns the parts of an element's form: what can be done, a picture, its fields. */
  private List<Form> parts(DocumentElement of) {
    List<Form> parts = new ArrayList<>();
    parts.add(form(of));
    if (MaterialForm.shows(of)) {
      parts.add(new MaterialForm(session, of));
    } else if (TextureForm.shows(of)) {
      parts.add(new TextureForm(session, of));
    }
    if (PlacementForm.shows(session, of)) {
      parts.add(new PlacementForm(session, of, keyboard));
    }
    parts.add(new FieldsForm(session, of, allFields));
    return parts;
  }

  private Form form(DocumentElement of) {
    Optional<Form> known =
        session
            .enrichment()
            .switchNode(of)
            .<Form>map(node -> new SwitchForm(session, pictures, node))
            .or(
                () ->
                    session.enrichment().sensorNode(of).map(node -> new SensorForm(session, node)));
    Form made =
        known.orElseGet(() -> new SummaryForm(session, of, wanted -> makeVersions.accept(wanted)));
    if (known.isPresent()) {
      (of.name().equals("Switch") ? HelpTopic.SWITCH : HelpTopic.SENSOR).mark(made.component());
    }
    return made;
  }

  private void head() {
    DocumentElement of = element;
    title.setText(of == null ? nothing() : name(of));
    place.setText(
        of == null
            ? " "
            : Texts.of(
                "form.line",
                of.name(),
                String.valueOf(session.document().location(of.start()).line())));
    place.setToolTipText(place.getText());
    findings.show(Optional.ofNullable(of));
  }

  private String nothing() {
    boolean waits = session.document().fault().isPresent();
    return waits ? Texts.of("node.formsWait") : Texts.of("form.nothing");
  }

  private static String name(DocumentElement of) {
    boolean prototype = of.name().equals("ProtoInstance") || of.name().endsWith("ProtoDeclare");
    return of.def()
        .or(of::use)
        .or(() -> of.text("name").filter(name -> prototype))
        .orElse(Texts.of("form.nameless", of.name()));
  }

  /** Stops following the session. */
  public void dispose() {
    session.removeSelectionListener(onSelection);
    session.document().removeListener(onChange);
    if (form != null) {
      form.dispose();
    }
  }

  /** A form composed of other forms of one node, one below the other. */
  private record CompositeForm(JComponent component, List<Form> forms) implements Form {
    static CompositeForm of(List<Form> forms) {
      JPanel panel = new JPanel(new MigLayout("insets 0, gap 0, wrap 1", "[grow,fill]"));
      for (Form form : forms) {
        panel.add(form.component(), "wmin 0");
      }
      return new CompositeForm(panel, List.copyOf(forms));
    }

    @Override
    public boolean fits() {
      return forms.stream().allMatch(Form::fits);
    }

    @Override
    public void follow() {
      forms.forEach(Form::follow);
    }

    @Override
    public void commit() {
      forms.forEach(Form::commit);
    }

    @Override
    public void dispose() {
      forms.forEach(Form::dispose);
    }
  }
}
