package org.selectiverenderer.enricher.ratings;

import java.util.Locale;
import org.selectiverenderer.authoring.ratings.GazeProposal;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyType;

/** The table model of the proposals from head logs, each of which can be accepted. */
@SuppressWarnings("serial") // never written
final class GazeTableModel extends RowTableModel<GazeProposal> {
  private static final long serialVersionUID = 1L;

  static final int ACCEPT = 0;

  private final RatingsImportModel model;

  GazeTableModel(RatingsImportModel model) {
    super(
        Texts.of("ratings.accept"),
        Texts.of("ratings.object"),
        Texts.of("ratings.schema"),
        Texts.of("ratings.rating"),
        Texts.of("ratings.degree"),
        Texts.of("ratings.interval"),
        Texts.of("ratings.evidence"),
        Texts.of("ratings.proposed"));
    this.model = model;
    model.addListener(() -> update(model.gaze().proposals()));
  }

  @Override
  protected Object cell(GazeProposal proposal, int column) {
    return switch (column) {
      case ACCEPT -> model.gaze().accepted(proposal);
      case 1 -> proposal.object();
      case 2 -> proposal.schema();
      case 3 ->
          proposal.rating().isPresent()
              ? DecimalFormatter.fixed(proposal.rating().getAsDouble(), 2)
              : "";
      case 4 -> DecimalFormatter.fixed(proposal.degree(), 2);
      case 5 ->
          Texts.of(
              "ratings.fromto",
              DecimalFormatter.fixed(proposal.low(), 2),
              DecimalFormatter.fixed(proposal.high(), 2));
      case 6 -> evidence(proposal.evidence());
      default -> proposed(proposal);
    };
  }

  private static String evidence(GazeProposal.Evidence evidence) {
    return Texts.of(
        "ratings.seen",
        DecimalFormatter.grouped(evidence.participants()),
        String.format(Locale.ROOT, "%.0f", evidence.inView()),
        DecimalFormatter.grouped(evidence.looks()));
  }

  private static String proposed(GazeProposal proposal) {
    String type =
        proposal
            .type()
            .map(ConsistencyType::spelling)
            .orElseGet(() -> Texts.of("ratings.undecided"));
    return proposal.type().isEmpty() || proposal.versions() > 1
        ? type
        : Texts.of("ratings.noversions", type);
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return column == ACCEPT ? Boolean.class : String.class;
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == ACCEPT && row(row).applicable();
  }

  @Override
  public void setValueAt(Object value, int row, int column) {
    model.accept(row(row), Boolean.TRUE.equals(value));
  }
}
