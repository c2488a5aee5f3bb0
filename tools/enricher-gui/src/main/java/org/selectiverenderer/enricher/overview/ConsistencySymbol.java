package org.selectiverenderer.enricher.overview;

import com.formdev.flatlaf.icons.FlatAbstractIcon;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Optional;
import org.selectiverenderer.authoring.enrichment.ObjectSchemaMatrix.Cell;
import org.selectiverenderer.enricher.table.StatusColors;
import org.selectiverenderer.enricher.text.Texts;
import org.selectiverenderer.schema.ConsistencyType;

/** The symbol of the consistency of an object with a schema: a shape as well as a colour. */
enum ConsistencySymbol {
  /** A filled disc. */
  CONSISTENT(Optional.of(StatusColors.CALM)),
  /** An empty diamond. */
  INCONSISTENT(Optional.of(StatusColors.ALERT)),
  /** An empty square: part of any place, such as a wall. */
  FRAME(Optional.of(StatusColors.NEUTRAL)),
  /** A ring of dashes: the object belongs to the schema, but the type is not set. */
  UNTYPED(Optional.of(StatusColors.NEUTRAL)),
  /** A short line: the object does not belong to the schema. */
  NONE(Optional.empty());

  private static final int SIZE = 12;

  private final Optional<Color> colour;

  ConsistencySymbol(Optional<Color> colour) {
    this.colour = colour;
  }

  static ConsistencySymbol of(Optional<Cell> cell) {
    if (cell.isEmpty()) {
      return NONE;
    }
    return cell.get().type().map(ConsistencySymbol::of).orElse(UNTYPED);
  }

  private static ConsistencySymbol of(ConsistencyType type) {
    return switch (type) {
      case CONSISTENT -> CONSISTENT;
      case INCONSISTENT -> INCONSISTENT;
      case FRAME -> FRAME;
    };
  }

  /** The meaning in words, as the legend shows it. */
  String words() {
    return switch (this) {
      case CONSISTENT -> Texts.of("overview.consistent");
      case INCONSISTENT -> Texts.of("overview.inconsistent");
      case FRAME -> Texts.of("overview.frame");
      case UNTYPED -> Texts.of("overview.untyped");
      case NONE -> Texts.of("overview.none");
    };
  }

  /** The background of a cell: the table's background with a tint. */
  Color ground(Color plain) {
    return colour.map(tint -> StatusColors.tint(plain, tint)).orElse(plain);
  }

  FlatAbstractIcon icon() {
    return new Icon(this);
  }

  private static final class Icon extends FlatAbstractIcon {
    private final ConsistencySymbol sign;

    Icon(ConsistencySymbol sign) {
      super(SIZE, SIZE, null);
      this.sign = sign;
    }

    @Override
    protected void paintIcon(Component component, Graphics2D g) {
      g.setColor(component.getForeground());
      g.setStroke(new BasicStroke(1.6f));
      switch (sign) {
        case CONSISTENT -> g.fill(new Ellipse2D.Double(2, 2, 8, 8));
        case INCONSISTENT -> {
          Path2D diamond = new Path2D.Double();
          diamond.moveTo(6, 1.5);
          diamond.lineTo(10.5, 6);
          diamond.lineTo(6, 10.5);
          diamond.lineTo(1.5, 6);
          diamond.closePath();
          g.draw(diamond);
        }
        case FRAME -> g.draw(new Rectangle2D.Double(2.5, 2.5, 7, 7));
        case UNTYPED -> {
          g.setStroke(
              new BasicStroke(
                  1.4f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1, new float[] {2, 2}, 0));
          g.draw(new Ellipse2D.Double(2, 2, 8, 8));
        }
        case NONE -> g.draw(new Line2D.Double(4, 6, 8, 6));
      }
    }
  }
}
