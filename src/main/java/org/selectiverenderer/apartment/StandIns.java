package org.selectiverenderer.apartment;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.selectiverenderer.modelling.Boxes;
import org.selectiverenderer.modelling.Colour;
import org.selectiverenderer.modelling.Look;
import org.selectiverenderer.modelling.Model;
import org.selectiverenderer.modelling.Part;
import org.selectiverenderer.modelling.Sheet;

final class StandIns {
  private static final String SIZES =
      """
      kitchenFurniture 3.6 0.9 0.6,kitchenTable 1.2 0.75 0.8,saltcellar 0.05 0.1 0.05,fruits 0.28 0.16 0.28
      glasses 0.3 0.14 0.16,hamburger 0.12 0.09 0.12,mixer 0.22 0.34 0.32,plates 0.26 0.08 0.26
      saucepan 0.4 0.16 0.22,spoons 0.06 0.01 0.18,teapot 0.26 0.17 0.18,toaster 0.3 0.2 0.17
      ashTray 0.12 0.03 0.12,candle 0.08 0.2 0.08,cigaretteSet 0.12 0.03 0.09,glass 0.07 0.12 0.07
      keys 0.1 0.01 0.06,loungeBooks 0.3 0.24 0.18,magazine 0.21 0.01 0.29,mobile 0.05 0.015 0.11
      remoteControl 0.05 0.02 0.18,sofa1Pillow 0.4 0.35 0.14,sofa2Pillow 0.4 0.35 0.14
      speakers 0.3 0.3 0.2,tv 0.7 0.5 0.3,vase 0.14 0.3 0.14,wine 0.08 0.3 0.08
      biblioteca 2.2 0.8 0.4,loungeTable 1.1 0.42 0.65,sofa1 2.0 0.8 0.9,sofa2 2.0 0.8 0.9
      printer 0.42 0.25 0.38,clock 0.3 0.3 0.05,selotape 0.12 0.06 0.06,pencilHolderDesk 0.08 0.14 0.08
      computerSet 0.6 0.45 0.45,cd 0.14 0.02 0.13,fireExtinguisher 0.16 0.5 0.16,plant 0.5 0.9 0.5
      deskLamp 0.2 0.45 0.3,mug 0.1 0.1 0.08,laptop 0.34 0.24 0.26,libraryBooks 0.5 0.25 0.2
      libraryMouse 0.06 0.04 0.11,telephoneLibrary 0.2 0.1 0.22,libraryPencilHolder 0.08 0.14 0.08
      carpet 2.72 0.014 1.8,floorLamp 0.4 1.6 0.4,painting 0.9 0.6 0.06,barrel 0.5 0.6 0.5,hammer 0.3 0.03 0.1,basketball 0.24 0.24 0.24,pumpkin 0.28 0.24 0.28
      ruler 0.31 0.003 0.035,desk 1.6 0.74 0.75,bookcase 2.4 0.9 0.4
      """;

  private StandIns() {}

  static Map<String, Supplier<Model>> all() {
    Map<String, Supplier<Model>> all = new TreeMap<>();
    for (String item : SIZES.strip().split("[,\n]")) {
      String[] words = item.split(" ");
      double w = Double.parseDouble(words[1]);
      double h = Double.parseDouble(words[2]);
      double d = Double.parseDouble(words[3]);
      Look look = Look.satin(Colour.hex(0x404040 | words[0].hashCode() & 0x7F7F7F));
      all.put(
          words[0],
          () ->
              Model.of(
                  words[0],
                  Part.of(
                      "box", look, Boxes.bevelled(w, h, d, Math.min(w, Math.min(h, d)) / 10, 1)),
                  Part.of("mark", look, Sheet.field(w / 2, d / 2, 1, 1, (x, z) -> h + 0.0005))));
    }
    return all;
  }
}
