package org.selectiverenderer.radiosity.command;

import java.util.List;
import org.selectiverenderer.command.CliCommand;
import org.selectiverenderer.command.CommandContext;
import org.selectiverenderer.command.CommandProvider;

/** Offers the command {@code radiosity} to the program. */
public final class RadiosityCommandProvider implements CommandProvider {
  @Override
  public List<String> names() {
    return List.of("radiosity");
  }

  @Override
  public CliCommand create(String name, CommandContext context) {
    return new RadiosityCommand(context.console());
  }
}
