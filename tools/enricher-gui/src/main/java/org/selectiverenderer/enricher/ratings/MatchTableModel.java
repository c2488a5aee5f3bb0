package org.selectiverenderer.enricher.ratings;

import java.util.Optional;
import org.selectiverenderer.authoring.ratings.ObjectNameMatcher.Match;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;

/** The table model that assigns a Switch to each object of the ratings; the Switch is editable. */
@SuppressWarnings("serial") // never written
final class MatchTableModel extends RowTableModel<Match> {
  private static final long serialVersionUID = 1L;

  /** The text for an object without a Switch. */
  static String none() {
    return Texts.of("ratings.none");
  }

  static final int SWITCH = 1;

  private final RatingsImportModel model;

  MatchTableModel(RatingsImportModel model) {
    super(Texts.of("ratings.object"), "Switch", Texts.of("ratings.why"));
    this.model = model;
    model.addListener(() -> update(model.matches()));
    show(model.matches());
  }

  @Override
  protected Object cell(Match match, int column) {
    return switch (column) {
      case 0 -> match.object();
      case SWITCH -> match.switchName().orElse(none());
      default ->
          switch (match.how()) {
            case SAME_NAME -> Texts.of("ratings.samename");
            case CHOSEN -> Texts.of("ratings.chosen");
            case PROPOSED -> Texts.of("ratings.similar");
            case NONE -> Texts.of("ratings.leftout");
          };
    };
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column == SWITCH;
  }

  @Override
  public void setValueAt(Object value, int row, int column) {
    String name = String.valueOf(value);
    if (value != null) {
      model.match(row(row).object(), name.equals(none()) ? Optional.empty() : Optional.of(name));
    }
  }
}
