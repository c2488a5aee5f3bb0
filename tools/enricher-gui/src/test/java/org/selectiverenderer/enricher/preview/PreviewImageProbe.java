package org.selectiverenderer.enricher.preview;

/** What the picture of a preview that is shown somewhere else has come to show. */
public final class PreviewImageProbe {
  private PreviewImageProbe() {}

  /** Whether it was drawn for the size, in pixels of the screen, that its place has now. */
  public static boolean fits(PreviewPanel panel) {
    PreviewCanvas view = panel.view();
    return view.frame()
        .map(PreviewFrame::image)
        .filter(image -> image.getWidth() == view.toPixels(view.getWidth()))
        .filter(image -> image.getHeight() == view.toPixels(view.getHeight()))
        .isPresent();
  }

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
