package org.selectiverenderer.enricher.form;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.SwingUtilities;
import org.selectiverenderer.authoring.enrichment.QualityTargets;
import org.selectiverenderer.enricher.session.EnricherSession;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A text field for a field of a named node, {@code SofaTexture.url}. It proposes the nodes with a
 * field that can be a quality, and then the fields of the node.
 */
final class TargetField extends CompletingField<TargetField.Proposal> {
  private static final long serialVersionUID = 1L;

  /** The most nodes that are proposed at once. */
  private static final int LIMIT = 100;

  /** A text that may be written, with the type of the node or field. */
  record Proposal(String text, String type) {
    @Override
    public String toString() {
      String name = text.endsWith(".") ? text.substring(0, text.length() - 1) : text;
      return name + "  (" + type + ")";
    }
  }

  private final transient EnricherSession session;
  private final transient DocumentElement object;

  /**
   * @param object the element of the Switch
   */
  TargetField(EnricherSession session, DocumentElement object) {
    super(Texts.of("quality.proposals"));
    this.session = session;
    this.object = object;
    putClientProperty("JTextField.placeholderText", Texts.of("quality.placeholder"));
  }

  @Override
  List<Proposal> proposals(boolean asked) {
    String typed = getText().substring(0, getCaretPosition()).strip();
    if (!object.attached() || typed.isEmpty() && !asked) {
      return List.of();
    }
    QualityTargets targets = new QualityTargets(session.document(), session.catalogue());
    Optional<DocumentElement> node = node(typed);
    List<Proposal> found =
        node.map(of -> fields(targets, of, typed))
            .orElseGet(
                () ->
                    targets.nodes(object, typed, LIMIT).stream()
                        .map(of -> new Proposal(of.def().orElse("") + ".", of.name()))
                        .toList());
    boolean done = found.size() == 1 && found.get(0).text().equals(typed);
    return done ? List.of() : found;
  }

  /** Returns the node whose name and a dot are typed. */
  private Optional<DocumentElement> node(String typed) {
    int dot = typed.lastIndexOf('.');
    return dot < 0
        ? Optional.empty()
        : session.document().tree().flatMap(tree -> tree.named(typed.substring(0, dot), object));
  }

  private static List<Proposal> fields(QualityTargets targets, DocumentElement node, String typed) {
    Stream<Proposal> all =
        targets.fields(node).stream()
            .map(
                field ->
                    new Proposal(
                        node.def().orElse("") + "." + field.name(), field.type().toString()));
    return all.filter(proposal -> proposal.text().startsWith(typed)).toList();
  }

  @Override
  void take(Proposal proposal) {
    setText(proposal.text());
    setCaretPosition(proposal.text().length());
    if (proposal.text().endsWith(".")) {
      SwingUtilities.invokeLater(() -> propose(true)); // now its fields
    }
  }
}
