package org.selectiverenderer.enricher.preview;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Rectangle;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.enricher.EventThread;

class WrapToolBarTest {
  @Test
  void buttonsWithoutRoomGoOnInAnotherLine() {
    EventThread.edt(
        () -> {
          WrapToolBar bar = new WrapToolBar("Tools");
          for (int i = 0; i < 8; i++) {
            bar.add(new JButton("Button " + i));
          }
          int line = bar.getPreferredSize().height;
          int all = bar.getPreferredSize().width;
          bar.setSize(all / 3, line);
          int height = bar.getPreferredSize().height;
          assertThat(height).isGreaterThan(2 * line);
          bar.setSize(all / 3, height);
          bar.doLayout();
          Rectangle inside = new Rectangle(0, 0, all / 3, height);
          assertThat(bar.getComponents())
              .allSatisfy(button -> assertThat(inside.contains(button.getBounds())).isTrue());
          assertThat(bar.getMinimumSize().width).isLessThan(all / 3);
        });
  }
}
