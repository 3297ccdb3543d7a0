"""The style of the pictures, and the panels that several share."""
