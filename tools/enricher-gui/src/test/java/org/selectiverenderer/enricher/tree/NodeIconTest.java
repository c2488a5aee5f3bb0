package org.selectiverenderer.enricher.tree;

import static org.assertj.core.api.Assertions.assertThat;

import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import javax.swing.JLabel;
import javax.swing.UIManager;
import org.junit.jupiter.api.Test;

class NodeIconTest {
  private static BufferedImage drawn(Color text) {
    BufferedImage image = new BufferedImage(16, 16, BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = image.createGraphics();
    JLabel row = new JLabel();
    row.setForeground(text);
    new NodeIcon(NodeIcon.Kind.GROUP, NodeIcon.Mark.NONE).paintIcon(row, graphics, 0, 0);
    graphics.dispose();
    return image;
  }

  private static boolean has(BufferedImage image, Color colour) {
    return Arrays.stream(image.getRGB(0, 0, 16, 16, null, 0, 16))
        .anyMatch(pixel -> pixel == colour.getRGB());
  }

  @Test
  void onASelectedRowItHasTheColourOfTheText() throws Exception {
    UIManager.setLookAndFeel(new FlatLightLaf());
    Color selected = UIManager.getColor("Tree.selectionForeground");
    Color grey = UIManager.getColor("Actions.Grey");
    assertThat(has(drawn(selected), new Color(selected.getRGB()))).isTrue();
    assertThat(has(drawn(selected), new Color(grey.getRGB()))).isFalse();
    assertThat(has(drawn(UIManager.getColor("Tree.foreground")), new Color(grey.getRGB())))
        .isTrue();
  }
}
