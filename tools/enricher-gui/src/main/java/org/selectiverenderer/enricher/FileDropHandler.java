package org.selectiverenderer.enricher;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.datatransfer.Clipboard;
import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.awt.event.InputEvent;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import org.jspecify.annotations.Nullable;

/**
 * Opens the first of the files dropped on a component. Everything else, such as text, goes to the
 * transfer handler that the component had before.
 */
final class FileDropHandler extends TransferHandler {
  private static final long serialVersionUID = 1L;

  /** Receives a file that is dropped on a component at a point. */
  @FunctionalInterface
  interface Receiver {
    void dropped(Path file, Component over, Point at);
  }

  private final transient Receiver open;
  private final @Nullable TransferHandler before;

  FileDropHandler(Receiver open) {
    this(open, null);
  }

  private FileDropHandler(Receiver open, @Nullable TransferHandler before) {
    this.open = open;
    this.before = before;
  }

  /**
   * Installs a file drop handler on every component in a container that has a transfer handler of
   * its own, which would otherwise reject files.
   */
  static void install(Container in, Receiver open) {
    for (Component each : in.getComponents()) {
      if (each instanceof JComponent component
          && component.getTransferHandler() != null
          && !(component.getTransferHandler() instanceof FileDropHandler)) {
        component.setTransferHandler(new FileDropHandler(open, component.getTransferHandler()));
      }
      if (each instanceof Container more) {
        install(more, open);
      }
    }
  }

  private static boolean files(TransferSupport support) {
    return support.isDataFlavorSupported(DataFlavor.javaFileListFlavor);
  }

  @Override
  public boolean canImport(TransferSupport support) {
    return files(support) || before != null && before.canImport(support);
  }

  @Override
  public boolean importData(TransferSupport support) {
    if (!files(support)) {
      return before != null && before.importData(support);
    }
    try {
      Object dropped = support.getTransferable().getTransferData(DataFlavor.javaFileListFlavor);
      if (dropped instanceof List<?> files
          && !files.isEmpty()
          && files.get(0) instanceof File file) {
        Point at = support.isDrop() ? support.getDropLocation().getDropPoint() : new Point();
        open.dropped(file.toPath(), support.getComponent(), at);
        return true;
      }
      return false;
    } catch (UnsupportedFlavorException | IOException e) {
      return false; // the drop is shown as refused
    }
  }

  @Override
  public int getSourceActions(JComponent component) {
    return before == null ? NONE : before.getSourceActions(component);
  }

  @Override
  public void exportAsDrag(JComponent component, InputEvent event, int action) {
    if (before != null) {
      before.exportAsDrag(component, event, action);
    }
  }

  @Override
  public void exportToClipboard(JComponent component, Clipboard clipboard, int action) {
    if (before != null) {
      before.exportToClipboard(component, clipboard, action);
    }
  }
}
