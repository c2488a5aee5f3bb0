package org.selectiverenderer.enricher.images;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.Icon;
import javax.swing.ImageIcon;
import org.selectiverenderer.authoring.images.ImageReference;
import org.selectiverenderer.enricher.table.RowTableModel;
import org.selectiverenderer.enricher.text.Texts;

/** The table of the scene's images: one row for the same urls. */
@SuppressWarnings("serial") // never written
final class ImagesTableModel extends RowTableModel<ImagesTableModel.Row> {
  private static final long serialVersionUID = 1L;

  static final int PICTURE = 0;
  static final int FILE = 1;
  static final int PIXELS = 2;
  static final int BYTES = 3;
  static final int CARD = 4;
  static final int USES = 5;
  static final int STATE = 6;

  private static final int SHOWN = 80;

  /**
   * An image.
   *
   * @param uses where the scene names it; at least one
   */
  record Row(List<ImageReference> uses, InspectedImage image) {
    List<String> urls() {
      return uses.get(0).urls();
    }
  }

  ImagesTableModel() {
    super(
        Texts.of("images.column.picture"),
        Texts.of("images.column.file"),
        Texts.of("images.column.pixels"),
        Texts.of("images.column.bytes"),
        Texts.of("images.column.card"),
        Texts.of("images.column.uses"),
        Texts.of("images.column.state"));
  }

  /** Shows the images, missing ones first. */
  void rows(List<Row> rows) {
    show(rows);
  }

  /** Returns all rows. */
  List<Row> rows() {
    return IntStream.range(0, getRowCount()).mapToObj(this::row).toList();
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return switch (column) {
      case PICTURE -> Icon.class;
      case USES -> Integer.class;
      default -> String.class;
    };
  }

  @Override
  protected Object cell(Row row, int column) {
    InspectedImage image = row.image();
    return switch (column) {
      case PICTURE -> image.thumbnail().<Icon>map(ImageIcon::new).orElse(new ImageIcon());
      case FILE -> file(row.urls().get(0));
      case PIXELS -> image.width() == 0 ? "" : image.width() + " \u00d7 " + image.height();
      case BYTES -> image.bytes() == 0 ? "" : ByteFormat.of(image.bytes());
      case CARD -> image.width() == 0 ? "" : ByteFormat.of(image.cardBytes());
      case USES -> row.uses().size();
      default -> image.fault();
    };
  }

  private static String file(String url) {
    Optional<String> name = ImageReference.fileName(url).map(file -> url.strip());
    String shown = name.orElseGet(() -> Texts.of("images.inside"));
    return shown.length() <= SHOWN ? shown : "\u2026" + shown.substring(shown.length() - SHOWN);
  }
}
