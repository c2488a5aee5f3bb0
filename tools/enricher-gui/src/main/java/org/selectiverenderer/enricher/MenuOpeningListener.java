package org.selectiverenderer.enricher;

import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/** Runs work, such as listing its items, when a menu is about to open. */
record MenuOpeningListener(Runnable work) implements MenuListener {
  @Override
  public void menuSelected(MenuEvent e) {
    work.run();
  }

  @Override
  public void menuDeselected(MenuEvent e) {
    // stays as it is
  }

  @Override
  public void menuCanceled(MenuEvent e) {
    // stays as it is
  }
}
