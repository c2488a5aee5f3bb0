package org.selectiverenderer.bench;

import java.util.Locale;

/** A Switch with metadata round an inlined object, in the shape that the thesis gives it (5.4). */
final class SwitchText {

  private SwitchText() {}

  /**
   * @param room the object is inconsistent in this room's area, consistent in the house
   */
  static void append(StringBuilder text, String name, double x, double z, int room) {
    text.append(
        String.format(
            Locale.ROOT,
            """
                <Transform translation='%.2f 0.42 %.2f'>
                  <Switch DEF='Switch_%3$s' whichChoice='0'>
                    <MetadataSet containerField='metadata' DEF='MetadataSet_%3$s'>
                      <MetadataSet containerField='value' DEF='MetadataSet_%3$s_Part1'>
                        <MetadataString containerField='value' name='consistencyType' value='"inconsistent"'/>
                        <MetadataString containerField='value' name='degreeOfConsistency' value='"low"'/>
                        <MetadataString containerField='value' name='schemaBelonginess' value='"Room%4$dSchema"'/>
                      </MetadataSet>
                      <MetadataSet containerField='value' DEF='MetadataSet_%3$s_Part2'>
                        <MetadataString containerField='value' name='consistencyType' value='"consistent"'/>
                        <MetadataString containerField='value' name='degreeOfConsistency' value='"high"'/>
                        <MetadataString containerField='value' name='schemaBelonginess' value='"HouseSchema"'/>
                      </MetadataSet>
                    </MetadataSet>
                    <Inline DEF='Inline_%3$s' url='"objects/%5$s.x3d"'/>
                    <Shape>
                      <Appearance>
                        <Material diffuseColor='0.6 0.6 0.6'/>
                      </Appearance>
                      <Box size='0.5 0.8 0.5'/>
                    </Shape>
                  </Switch>
                </Transform>
            """,
            x,
            z,
            name,
            room,
            name.toLowerCase(Locale.ROOT)));
  }
}
