package org.selectiverenderer.enricher.preview;

/** What the picture of a preview that is shown somewhere else has come to show. */
public final class PreviewImageProbe {
  private PreviewImageProbe() {}

  /** Whether the object that is selected is outlined in it. */
  public static boolean selected(PreviewPanel panel) {
    return panel.view().frame().filter(frame -> frame.selected().isPresent()).isPresent();
  }

  /** The document's revision that it shows; -1 while it shows nothing. */
  public static long revision(PreviewPanel panel) {
    return panel.view().frame().map(PreviewFrame::revision).orElse(-1L);
  }

  /** Whether it is compared with all polygons, as if in schemas. */
  public static boolean comparedAsIf(PreviewPanel panel) {
    return panel
        .view()
        .frame()
        .filter(frame -> frame.compared().isPresent() && !frame.schemas().isEmpty())
        .isPresent();
  }
}
