"""The commands of ./reproduce.sh."""
