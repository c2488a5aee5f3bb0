package org.selectiverenderer.enricher.ratings;

import java.util.Optional;
import org.selectiverenderer.document.ratings.ObjectMatching.Match;
import org.selectiverenderer.enricher.table.RowTableModel;

/** Which Switch each object of the table is; the Switch can be corrected. */
@SuppressWarnings("serial") // never written
final class MatchTableModel extends RowTableModel<Match> {
  private static final long serialVersionUID = 1L;

  /** What stands for an object that is no Switch. */
  static final String NONE = "(leave out)";

  static final int SWITCH = 1;

  private final RatingsModel model;

  MatchTableModel(RatingsModel model) {
    super("Object in the table", "Switch", "Why");
    this.model = model;
    model.addListener(() -> update(model.matches()));
    show(model.matches());
  }

  @Override
  protected Object cell(Match match, int column) {
    return switch (column) {
      case 0 -> match.object();
      case SWITCH -> match.switchName().orElse(NONE);
      default ->
          switch (match.how()) {
            case SAME_NAME -> "same name";
            case CHOSEN -> "chosen";
            case PROPOSED -> "\u26a0 only similar: choose to use";
            case NONE -> "left out";
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
      model.match(row(row).object(), name.equals(NONE) ? Optional.empty() : Optional.of(name));
    }
  }
}
